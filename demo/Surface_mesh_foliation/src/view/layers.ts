// What the picture shows, as the panel has it.
import type { Coloring } from '../coloring';

export interface Layers {
  coloring: Coloring;
  surface: boolean;
  leaves: boolean;
  leavesPerArc: number;
  skeleton: boolean;
  radius: boolean;
  nodes: boolean;
  poles: boolean;
  loops: boolean;
  singularities: boolean;
  edgeValues: boolean;
}

export const FIRST_LAYERS: Layers = {
  coloring: 'parts',
  surface: true,
  leaves: false,
  leavesPerArc: 12,
  skeleton: true,
  radius: false,
  nodes: true,
  poles: true,
  loops: false,
  singularities: false,
  edgeValues: false,
};

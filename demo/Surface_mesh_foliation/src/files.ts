// The files that the engine writes, with what they are for.
import { downloads } from './protocol';

export type File_name = (typeof downloads)[number];

export const USES: Record<File_name, string> = {
  'reeb_graph.graphml': 'the graph, for networkx and Gephi',
  'reeb_graph.dot': 'the graph, for Graphviz',
  'reeb_graph.json': 'the graph and all numbers',
  'segments.ply': 'the mesh with the part of each face',
  'components.ply': 'the mesh cut into its parts',
  'components.obj': 'the parts with texture coordinates',
  'skeleton.ply': 'the skeleton with radii',
  'skeleton.swc': 'the skeleton, for programs that trace neurons',
  'leaves.ply': 'leaves, as polylines',
  'foliation.ply': 'the mesh with arc and position of each vertex',
  'edge_values.csv': 'the foliation, edge by edge',
  'components.vtp': 'for ParaView',
  'coordinates.vtp': 'for ParaView',
  'leaves.vtp': 'for ParaView',
  'skeleton.vtp': 'for ParaView',
  'foliation.vtp': 'for ParaView',
  'singularities.vtp': 'for ParaView',
};

export const OUTPUT_FILES = Object.keys(USES) as File_name[];

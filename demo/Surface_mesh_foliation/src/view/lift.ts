// What lies on the surface is drawn a little nearer to the eye, so that it does not sink in.

/** A statement for vertex shaders, of perspective cameras: nearer by a share of the distance. */
export function liftTowardEye(share: number): string {
  return `gl_Position.z += ${share.toFixed(6)} * projectionMatrix[3][2];`;
}

// Where the camera stands when a mesh is opened, and how the keys turn it.
import * as THREE from 'three';

/** Looks along the shortest side of the box, so that most of the shape is seen. */
export function firstDirection(box: THREE.Box3): { direction: THREE.Vector3; up: THREE.Vector3 } {
  const size = box.getSize(new THREE.Vector3());
  const least = Math.min(size.x, size.y, size.z);
  const y = new THREE.Vector3(0, 1, 0);
  if (size.z === least) return { direction: new THREE.Vector3(0.25, 0.15, 1).normalize(), up: y };
  if (size.x === least) return { direction: new THREE.Vector3(1, 0.15, 0.25).normalize(), up: y };
  return {
    direction: new THREE.Vector3(0.25, -1, 0.15).normalize(),
    up: new THREE.Vector3(0, 0, 1),
  };
}

/** So far away that the sphere fits into the picture, whatever its shape. */
export function fittingDistance(radius: number, camera: THREE.PerspectiveCamera): number {
  const half = THREE.MathUtils.degToRad(camera.fov) / 2;
  const narrow = camera.aspect < 1 ? Math.atan(Math.tan(half) * camera.aspect) : half;
  return radius / Math.sin(narrow);
}

export function boxOf(positions: ArrayLike<number>): THREE.Box3 {
  const box = new THREE.Box3();
  const point = new THREE.Vector3();
  for (let i = 0; i < positions.length; i += 3)
    box.expandByPoint(point.set(positions[i], positions[i + 1], positions[i + 2]));
  return box;
}

/** Turns the camera around its target, by angles to the right and upward. */
export function orbit(
  camera: THREE.Camera,
  target: THREE.Vector3,
  right: number,
  up: number,
): void {
  const toUpAxis = new THREE.Quaternion().setFromUnitVectors(camera.up, new THREE.Vector3(0, 1, 0));
  const offset = camera.position.clone().sub(target).applyQuaternion(toUpAxis);
  const spherical = new THREE.Spherical().setFromVector3(offset);
  spherical.theta += right;
  spherical.phi = THREE.MathUtils.clamp(spherical.phi + up, 0.01, Math.PI - 0.01);
  offset.setFromSpherical(spherical).applyQuaternion(toUpAxis.invert());
  camera.position.copy(target).add(offset);
  camera.lookAt(target);
}

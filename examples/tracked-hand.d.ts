import type { Object3D, Quaternion, Vector3 } from 'three'

/** Joints by their names in WebXR. */
export type HandJoints = Record<string, { position?: Vector3; quaternion: Quaternion; visible: boolean }>

export function handPoser(hand: Object3D): (joints: HandJoints) => void
export function simulatedJoints(fist: number, position: Vector3): HandJoints

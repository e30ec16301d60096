import type { AutoWrinkles } from 'furrow/author'
import { isFolding, placeOfArea, poseOfDriver, viewOfPlace } from 'furrow/internal'
import type { FoundSkin } from 'furrow-files'
import type { CloseUpView, JointRotation } from '../../render/picture.ts'

/** Surface with its wrinkles. */
export interface PosedSurface {
  found: Pick<FoundSkin, 'meshName' | 'skin'>
  wrinkles: Pick<AutoWrinkles, 'jointAreas'>
}

/** Pose of joints that folds an area, and a view of this area. */
export interface JointPose {
  /** Name of the area. */
  name: string
  mesh: string
  /** Rotation of each turned joint from its rest pose. */
  joints: Record<string, JointRotation>
  /** Last turned joint, and the total angle in degrees. */
  joint: string
  degrees: number
  view: CloseUpView
}

/** Maximum number of poses. The largest areas come first, because they are most visible. */
const MAX_POSES = 8

/** Returns the poses that fold the largest areas of a character, without those that a pose smooths. */
export function jointPosesOf(surfaces: readonly PosedSurface[]): JointPose[] {
  const all = surfaces.flatMap(({ found: { meshName, skin }, wrinkles }) =>
    wrinkles.jointAreas.flatMap(({ name, weights, drivers: [driver] }) => {
      const place = isFolding(driver) ? placeOfArea(skin, weights) : undefined
      const pose = place && poseOfDriver(skin.skeleton!.joints, driver)
      if (!place || !pose) return []
      const { joints, joint, angle } = pose
      const degrees = Math.round((angle * 180) / Math.PI)
      return [{ size: place.size, name, mesh: meshName, joints, joint, degrees, view: viewOfPlace(place) }]
    }),
  )
  const largest = all.sort((a, b) => b.size - a.size).slice(0, MAX_POSES)
  return largest.map(({ size: _, ...pose }) => pose)
}

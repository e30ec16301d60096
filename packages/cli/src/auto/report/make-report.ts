import { writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { encodeGlb, type Glb, type OutputFile, type Progress, parseWrinkledFile } from 'furrow-files'
import { temporaryFolder } from '../../interruption.ts'
import type { Steps } from '../steps.ts'
import { type JointPose, jointPosesOf } from './joint-poses.ts'
import { reportPage } from './page.ts'
import { drawAreas, drawFaces, drawJoints, drawLayers, drawStrain } from './pictures.ts'
import { type Pose, posesOf } from './poses.ts'
import type { ReportSource } from './report-source.ts'

export interface ReportFiles {
  files: OutputFile[]
  /** Reason why the report has no pictures of the face. Absent if it has them. */
  missing?: string
}

/**
 * Creates the HTML report of `furrow auto` and its images in memory.
 *
 * @param folder folder of the report, for the paths of the files.
 * @param steps progress. The function begins the steps `report` and `pictures`.
 */
export async function makeReport(
  source: ReportSource,
  folder: string,
  steps: Steps,
  who: string,
): Promise<ReportFiles> {
  const { path, glb, found, wrinkles } = source
  steps.begin('report')
  const file = parseWrinkledFile(glb, found.material, who)
  const poses = posesOf(wrinkles)
  const strain = await drawStrain(found.skin, poses)
  const areas = await drawAreas(file, who)
  const layers = await drawLayers(file, who)
  steps.begin('pictures')
  const jointPoses = jointPosesOf(source.surfaces)
  const { faces, joints } = await drawFile(glb, poses, jointPoses, (done, total) => steps.part(done, total))
  const page = reportPage({
    ...source,
    title: basename(path),
    poses,
    strain,
    areas,
    layers,
    faces,
    jointPoses,
    joints,
    times: steps.times(),
  })
  const drawn = [faces, joints].flatMap((pictures) => (typeof pictures === 'string' ? [] : pictures.flat()))
  const images = [...strain, ...areas, ...layers.flat(), ...drawn]
  const missing = [faces, joints].find((pictures) => typeof pictures === 'string')
  const files = images.map(({ file: name, bytes }) => ({ path: join(folder, name), bytes }))
  return {
    files: [...files, { path: join(folder, 'index.html'), bytes: Buffer.from(page) }],
    ...(missing !== undefined && { missing }),
  }
}

/** Draws expressions and poses of joints. Writes the file to a temporary folder first, because `drawFaces` and `drawJoints` read a file. */
async function drawFile(
  glb: Glb,
  poses: readonly Pose[],
  jointPoses: readonly JointPose[],
  progress: Progress,
) {
  const folder = temporaryFolder()
  try {
    const path = join(folder.path, 'face.glb')
    writeFileSync(path, encodeGlb(glb))
    const ofFaces = 2 * poses.length
    const total = ofFaces + 3 * jointPoses.length
    const faces = poses.length === 0 ? [] : await drawFaces(path, poses, (done) => progress(done, total))
    const isMissing = typeof faces === 'string' || jointPoses.length === 0
    const joints = isMissing
      ? []
      : await drawJoints(path, jointPoses, (done) => progress(ofFaces + done, total))
    return { faces, joints }
  } finally {
    await folder.remove()
  }
}

import { writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { encodeGlb, type Glb, type OutputFile, type Progress, parseWrinkledFile } from 'furrow-files'
import { temporaryFolder } from '../../interruption.ts'
import type { Steps } from '../steps.ts'
import { reportPage } from './page.ts'
import { drawAreas, drawFaces, drawLayers, drawStrain } from './pictures.ts'
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
  const faces = await drawFile(glb, poses, (done, total) => steps.part(done, total))
  const page = reportPage({
    ...source,
    title: basename(path),
    poses,
    strain,
    areas,
    layers,
    faces,
    times: steps.times(),
  })
  const isDrawn = typeof faces !== 'string'
  const images = [...strain, ...areas, ...layers.flat(), ...(isDrawn ? faces.flat() : [])]
  const files = images.map(({ file: name, bytes }) => ({ path: join(folder, name), bytes }))
  return {
    files: [...files, { path: join(folder, 'index.html'), bytes: Buffer.from(page) }],
    ...(!isDrawn && { missing: faces }),
  }
}

/** Draws a face. Writes it to a temporary file first, because `drawFaces` reads a file. */
async function drawFile(glb: Glb, poses: readonly Pose[], progress: Progress) {
  const folder = temporaryFolder()
  try {
    const path = join(folder.path, 'face.glb')
    writeFileSync(path, encodeGlb(glb))
    return await drawFaces(path, poses, progress)
  } finally {
    await folder.remove()
  }
}

import { basename, join } from 'node:path'
import { parseWrinkleMaps, WRINKLE_MAPS } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'
import type { Output } from '../images.ts'
import type { Glb } from '../wrinkles/glb-file.ts'
import { posesOf } from './expressions.ts'
import type { FoundSkin } from './read-skin.ts'
import { reportPage } from './report-page.ts'
import { drawAreas, drawFaces, drawLayers, drawStrain } from './report-pictures.ts'
import type { Steps } from './steps.ts'

/** What a report is made from. */
export interface ReportSource {
  /** The file with the wrinkles, as it was written. */
  path: string
  glb: Glb
  found: FoundSkin
  wrinkles: AutoWrinkles
  /** By name, as the user could have written them. */
  settings: Readonly<Record<string, string | number>>
  warnings: readonly string[]
}

/** What `makeReport` made. */
export interface Report {
  files: Output[]
  /** Why it has no pictures of the face, where it has none. */
  missing?: string
}

/**
 * Makes the report of `furrow auto`: a page and its pictures, for one folder.
 *
 * @param steps two are begun.
 */
export async function makeReport(
  source: ReportSource,
  folder: string,
  steps: Steps,
  who: string,
): Promise<Report> {
  const { path, glb, found, wrinkles } = source
  steps.begin('report')
  const extension = glb.json.materials![found.material].extensions![WRINKLE_MAPS]
  const maps = parseWrinkleMaps(extension, glb.json.textures?.length ?? 0, who)
  const file = { glb, material: found.material, maps }
  const poses = posesOf(wrinkles)
  const strain = await drawStrain(found.skin, poses)
  const areas = await drawAreas(file, who)
  const layers = await drawLayers(file, who)
  steps.begin('pictures')
  const faces = await drawFaces(path, poses, (done, total) => steps.part(done, total))
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

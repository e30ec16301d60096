import { cpSync, mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from '../../scripts/lib/run.mjs'
import { gatherFace } from './face.mjs'

/** Writes the first page, its compressed face, and the posters that the page shows until the face is loaded. */
export async function gatherFirstPage(folder) {
  cpSync(join(ROOT, 'site/first-page/index.md'), join(folder, 'index.md'))
  const assets = join(folder, 'public/first-page')
  mkdirSync(assets, { recursive: true })
  for (const poster of ['poster.webp', 'poster-small.webp']) {
    cpSync(join(ROOT, 'site/first-page', poster), join(assets, poster))
  }
  await gatherFace(join(ROOT, 'faces/human.glb'), join(assets, 'face.glb'))
}

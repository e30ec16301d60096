import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { drawPictures } from '../../../scripts/figures/draw.mjs'
import { GAP, writeSheet } from '../../../scripts/figures/write.mjs'
import { say } from '../../../scripts/lib/run.mjs'

/** File in a folder of sheets that describes them to the other commands. */
export const DESCRIPTION = 'sheets.json'

/**
 * Describes the sheets of a folder. Sheets may be missing, because a run can draw some of them.
 *
 * @param tile height of a picture, pixels.
 * @param versions title of each version, by the name in the files.
 * @param parts parts of sheets that readers score, in the order of the table of scores: `sheet`, `region` (name for readers), `firstRow`
 *   and `rows`.
 */
export function describeSheets(folder, { tile, versions, parts }) {
  mkdirSync(folder, { recursive: true })
  const description = { rowHeight: tile + GAP, gap: GAP, versions, parts }
  writeFileSync(join(folder, DESCRIPTION), `${JSON.stringify(description, null, 2)}\n`)
}

/**
 * Draws sheets and writes them to `SHEET-VERSION.jpg`.
 *
 * @param shots square pictures, row by row: the request `picture` to `renderPictures`, with the names of its `sheet` and `version`.
 *   `beginsRow` starts a row.
 */
export async function drawSheets(folder, shots) {
  const pictures = await drawPictures(shots.map(({ picture }) => picture))
  const files = shots.map(({ sheet, version }) => join(folder, `${sheet}-${version}.jpg`))
  for (const file of new Set(files)) {
    const shown = pictures.flatMap((picture, i) => {
      const crop = { left: 0, top: 0, width: picture.width, height: picture.height }
      return files[i] === file ? { ...picture, crop, beginsRow: shots[i].beginsRow } : []
    })
    await writeSheet(shown, file)
    say(file)
  }
}

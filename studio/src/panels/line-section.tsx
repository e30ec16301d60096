import { addSection, HeightSum, isBulge, sectionOf } from 'furrow/internal'
import { sectionLabel } from '../labels/lines.ts'
import type { LineShape } from '../lines/line-shape.ts'

/** Size of the picture, CSS pixels, and the height of the skin around the line. */
const [WIDTH, HEIGHT, SKIN] = [240, 84, 34] as const
/** Half of the shown width, and pixels per millimetre. */
const REACH = 12
const SCALE = WIDTH / (2 * REACH)
/** Factor on heights, which are small compared to widths. */
const EXAGGERATION = 1.6

/** Picture of the cross-section of a line. */
export function LineSection({ line, label }: { line: LineShape; label: string }) {
  const points = Array.from({ length: WIDTH / 2 + 1 }, (_, i) => {
    const x = 2 * i
    const height = heightAt(line, x / SCALE - REACH)
    return `${x},${(SKIN - height * SCALE * EXAGGERATION).toFixed(1)}`
  })
  return (
    <svg
      class="line-section"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={sectionLabel(label, line.depth, isBulge(line))}
    >
      <path class="skin" d={`M${points.join('L')}V${HEIGHT}H0Z`} />
    </svg>
  )
}

const sum = new HeightSum()

/** Returns the height of the skin at a distance across a line, both in millimetres. */
function heightAt(line: LineShape, across: number): number {
  sum.clear()
  addSection(sum, sectionOf(line), line.depth, line.width / 2, Math.abs(across), Math.sign(across), 0)
  return sum.height
}

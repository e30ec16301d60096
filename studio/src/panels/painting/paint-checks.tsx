import { PAINT } from '../../labels/brushes.ts'
import type { Painting } from '../../tools/painting.ts'
import { Check } from '../controls/check.tsx'

/** Check box for an option that the brush and the polygon share. */
export function PaintChecks({ painting }: { painting: Painting }) {
  return (
    <div class="add checks">
      <Check value={painting.isHiddenPainted} title={PAINT.throughHint}>
        {PAINT.through}
      </Check>
    </div>
  )
}

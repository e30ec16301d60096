import type { Painting } from '../../tools/painting.ts'
import { Check } from '../controls/check.tsx'

/** Check box for an option that the brush and the polygon share. */
export function PaintChecks({ painting }: { painting: Painting }) {
  return (
    <div class="add checks">
      <Check value={painting.isHiddenPainted} title="Also paint skin that the camera does not see">
        Paint through
      </Check>
    </div>
  )
}

import type { Painting } from '../../tools/painting.ts'

/** Check box for an option that the brush and the polygon share. */
export function PaintChecks({ painting }: { painting: Painting }) {
  return (
    <div class="add checks">
      <label class="check" title="Also paint skin that the camera does not see">
        <input
          type="checkbox"
          checked={painting.isHiddenPainted.value}
          onChange={({ currentTarget }) => {
            painting.isHiddenPainted.value = currentTarget.checked
          }}
        />
        Paint through
      </label>
    </div>
  )
}

import type { Painting } from '../../tools/painting.ts'

/** Check boxes for options that the brush and the polygon share. */
export function PaintChecks({ painting }: { painting: Painting }) {
  const { mirror } = painting.brush.value
  return (
    <div class="add checks">
      <label class="check">
        <input
          type="checkbox"
          checked={mirror}
          onChange={({ currentTarget }) => {
            painting.brush.value = { ...painting.brush.peek(), mirror: currentTarget.checked }
          }}
        />
        Mirror
      </label>
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

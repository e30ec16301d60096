import type { PanelModel } from '../model.ts'
import { useThrottled } from './throttled.ts'

/** Text with the contributions of drivers and their inputs to an area. It is updated while the face moves. */
export function Reasons({ area, model: { viewer, frame } }: { area: string; model: PanelModel }) {
  useThrottled(frame).value
  return (
    <p class="explanation">
      {viewer.value?.driven.drivers.explain(area).map((line) => (
        <>
          {line}
          <br />
        </>
      ))}
    </p>
  )
}

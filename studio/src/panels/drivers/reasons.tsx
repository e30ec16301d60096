import type { PanelModel } from '../model.ts'
import { useThrottled } from './throttled.ts'

/** Contributions of drivers and inputs to an area, updated as the face moves. */
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

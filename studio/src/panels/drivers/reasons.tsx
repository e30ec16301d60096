import type { PanelModel } from '../model.ts'
import { useSlowed } from './live.ts'

/** What each driver gives to an area, and each input to the driver, one line each, as the face moves. */
export function Reasons({ area, model: { viewer, frame } }: { area: string; model: PanelModel }) {
  useSlowed(frame).value
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

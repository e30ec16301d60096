import { UNSET } from '../document/drivers.ts'
import { CARD, inExpression } from '../labels/stage.ts'
import type { PanelModel } from '../panels/model.ts'

interface WhenQuestionProps {
  model: PanelModel
  /** Areas that were added on bare skin. */
  added: readonly string[]
  onAnswer(): void
}

/** Asks when wrinkles on bare skin show: always, or with the expression that the face has. */
export function WhenQuestion({ model, added, onAnswer }: WhenQuestionProps) {
  const { areas, viewer, frame, expression, actions } = model
  frame.value
  const isPosed = viewer.value?.targets.some((dial) => dial.read() > UNSET)
  const answer = (change?: () => void) => {
    change?.()
    onAnswer()
  }
  return (
    <fieldset class="when">
      <legend>{CARD.shows}</legend>
      <div class="work">
        <button type="button" onClick={() => answer()}>
          {CARD.always}
        </button>
        {isPosed && (
          <button type="button" onClick={() => answer(() => areas.showInPose(added, actions.pose()))}>
            {inExpression(expression.value)}
          </button>
        )}
      </div>
      {!isPosed && <p class="hint">{CARD.noPose}</p>}
    </fieldset>
  )
}

import { durationOf, type Take } from '../../document/take.ts'
import { nameOfTakeLabel, TAKES } from '../../labels/live.ts'
import { PLACES } from '../../labels/page.ts'
import type { TakeEditor } from '../../session/take-editor.ts'
import { FileButton } from '../controls/file-button.tsx'
import { Section } from '../controls/section.tsx'
import { TextField } from '../controls/text-field.tsx'
import type { PanelModel } from '../model.ts'
import { ClipList } from './clip-list.tsx'

/** Takes of the project. */
export function TakesSection({ model: { player, takes, actions } }: { model: PanelModel }) {
  const chosen = takes.chosen.value
  return (
    <Section title={PLACES.takes}>
      {player.takes.value.length === 0 && <p class="hint">{TAKES.none}</p>}
      <ClipList label={PLACES.takes} clips={player.takes.value} player={player} />
      {chosen && <ChosenTake take={chosen} editor={takes} attempt={actions.attempt} />}
      <div class="work">
        <FileButton accept=".csv" isMultiple onChoose={actions.openFiles}>
          {TAKES.open}
        </FileButton>
      </div>
    </Section>
  )
}

interface ChosenTakeProps {
  take: Take
  editor: TakeEditor
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): void
}

function ChosenTake({ take, editor, attempt }: ChosenTakeProps) {
  const { name } = take
  return (
    <div class="settings chosen-take">
      <TextField
        label={TAKES.name}
        fullLabel={nameOfTakeLabel(name)}
        value={name}
        onChange={(next) => editor.rename(name, next.trim())}
      />
      <div class="work">
        <button type="button" title={TAKES.saveHint} onClick={() => attempt(() => editor.save(take))}>
          {TAKES.save}
        </button>
        {take.range && (
          <button
            type="button"
            title={TAKES.wholeHint}
            onClick={() => editor.trim(name, [0, durationOf(take.motion)])}
          >
            {TAKES.whole}
          </button>
        )}
        <button type="button" onClick={() => editor.remove(name)}>
          {TAKES.remove}
        </button>
      </div>
    </div>
  )
}

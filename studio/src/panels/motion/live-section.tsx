import {
  calibratingLabel,
  connectedLabel,
  LIVE,
  recordedLabel,
  SOURCE_HINTS,
  SOURCES,
  STATUS,
} from '../../labels/live.ts'
import { PLACES } from '../../labels/page.ts'
import type { Live } from '../../live/live.ts'
import { type LiveSettings, SOURCE_NAMES } from '../../live/settings.ts'
import { CheckBox } from '../controls/check.tsx'
import { Choice } from '../controls/choice.tsx'
import { FileButton } from '../controls/file-button.tsx'
import { LabelledGroup } from '../controls/labelled-group.tsx'
import { Section } from '../controls/section.tsx'
import { TextField } from '../controls/text-field.tsx'
import type { PanelModel } from '../model.ts'

const OPTIONS = SOURCE_NAMES.map((value) => ({ value, label: SOURCES[value] }))

/** A webcam, a phone, a program or a voice moves the face: its source, its state, calibration and recording. */
export function LiveSection({ model }: { model: PanelModel }) {
  const { live, actions } = model
  const { status, settings } = live
  const { source } = settings.value
  const isOn = status.value !== null
  return (
    <Section title={PLACES.live}>
      <div class="settings">
        {!isOn && (
          <>
            <Choice
              label={LIVE.source}
              options={OPTIONS}
              columns={2}
              value={source}
              onChange={(next) => live.change({ source: next })}
            />
            <p class="hint">{SOURCE_HINTS[source]}</p>
            {source === 'phone' && (
              <TextSetting
                live={live}
                name="address"
                label={LIVE.address}
                placeholder={LIVE.addressExample}
              />
            )}
          </>
        )}
        <Status live={live} />
        <div class="work">
          {isOn ? (
            <button type="button" title={LIVE.stopHint} onClick={() => live.stop()}>
              {LIVE.stop}
            </button>
          ) : (
            <button type="button" onClick={actions.startLive}>
              {LIVE.start}
            </button>
          )}
          {live.sender.value !== null && <RecordButton model={model} />}
        </div>
        {live.sender.value !== null && <Calibration model={model} />}
        <Flag live={live} name="mirror" label={LIVE.mirror} title={LIVE.mirrorHint} />
        <Flag live={live} name="isSmooth" label={LIVE.smooth} />
        {!isOn && source === 'webcam' && (
          <details class="live-settings">
            <summary>{LIVE.settings}</summary>
            <div class="settings">
              <TextSetting live={live} name="library" label={LIVE.library} />
              <TextSetting live={live} name="model" label={LIVE.model} />
            </div>
          </details>
        )}
      </div>
    </Section>
  )
}

/** State of the source, which screen readers announce. */
function Status({ live: { status, sender, calibrating, recorded } }: { live: Live }) {
  const state = status.value
  const running = calibrating.value
  let text = state && state !== 'connected' ? STATUS[state] : ''
  if (running) text = calibratingLabel(running.kind, running.left)
  else if (state === 'connected') text = connectedLabel(sender.value ?? '')
  return (
    <div>
      <p class={running ? 'hint countdown' : 'hint'} role="status">
        {text}
      </p>
      {recorded.value !== null && <p class="hint countdown">{recordedLabel(recorded.value)}</p>}
    </div>
  )
}

function RecordButton({ model: { live, actions } }: { model: PanelModel }) {
  const start = live.isPreparing.value ? LIVE.preparing : LIVE.record
  return (
    <button type="button" aria-keyshortcuts="r" onClick={() => actions.attempt(() => live.toggleRecording())}>
      {live.recorded.value === null ? start : LIVE.finish}
    </button>
  )
}

function Calibration({ model: { live, actions } }: { model: PanelModel }) {
  const isCalibrated = live.isCalibrated.value
  return (
    <LabelledGroup label={LIVE.calibration} class="calibration">
      <p class="hint">{isCalibrated ? LIVE.isCalibrated : LIVE.notCalibrated}</p>
      <div class="work">
        <button type="button" title={LIVE.neutralHint} onClick={() => live.calibrate('neutral')}>
          {LIVE.neutral}
        </button>
        <button type="button" title={LIVE.rangeHint} onClick={() => live.calibrate('range')}>
          {LIVE.range}
        </button>
        {isCalibrated && (
          <>
            <button type="button" onClick={actions.saveCalibration}>
              {LIVE.save}
            </button>
            <button type="button" onClick={() => live.setCalibration(null)}>
              {LIVE.reset}
            </button>
          </>
        )}
        <FileButton accept=".json" onChoose={([file]) => actions.loadCalibration(file)}>
          {LIVE.load}
        </FileButton>
      </div>
    </LabelledGroup>
  )
}

/** Names of settings of a type. */
type NameOf<T> = {
  [Name in keyof LiveSettings]: LiveSettings[Name] extends T ? Name : never
}[keyof LiveSettings]

interface SettingProps<T> {
  live: Live
  name: NameOf<T>
  label: string
}

function Flag({ live, name, label, title }: SettingProps<boolean> & { title?: string }) {
  return (
    <CheckBox
      isChecked={live.settings.value[name] as boolean}
      title={title}
      onChange={(isChecked) => live.change({ [name]: isChecked })}
    >
      {label}
    </CheckBox>
  )
}

function TextSetting({ live, name, ...field }: SettingProps<string> & { placeholder?: string }) {
  return (
    <TextField
      {...field}
      value={live.settings.value[name] as string}
      onInput={(value) => live.change({ [name]: value.trim() })}
    />
  )
}

import { normalizeProps, useMachine } from '@zag-js/preact'
import * as tooltip from '@zag-js/tooltip'
import { useId } from 'preact/hooks'
import { Icon, type IconName } from './icon.tsx'

interface ToolButtonProps {
  label: string
  icon: IconName
  shortcut?: string
  isPressed: boolean
  isDisabled?: boolean
  onPress(): void
}

/** Icon button with two states. A tooltip shows its label and its key. */
export function ToolButton({ label, icon, shortcut, isPressed, isDisabled, onPress }: ToolButtonProps) {
  const service = useMachine(tooltip.machine, {
    id: useId(),
    openDelay: 300,
    positioning: { placement: 'right', strategy: 'fixed', gutter: 8 },
  })
  const api = tooltip.connect(service, normalizeProps)
  return (
    <>
      <button
        {...api.getTriggerProps()}
        type="button"
        class="tool"
        aria-label={label}
        aria-pressed={isPressed}
        aria-keyshortcuts={shortcut}
        disabled={isDisabled}
        onClick={onPress}
      >
        <Icon name={icon} />
      </button>
      {api.open && (
        <div {...api.getPositionerProps()} class="popover-place">
          <div {...api.getContentProps()} class="tooltip">
            {label} {shortcut && <kbd>{shortcut}</kbd>}
          </div>
        </div>
      )}
    </>
  )
}

import { PAGE, TOOLS } from '../labels/page.ts'
import type { PanelModel } from '../panels/model.ts'
import { SHORTCUTS } from '../shortcuts.ts'
import { TOOL_NAMES } from '../tools/tool-choice.ts'
import { ToolButton } from '../ui/tool-button.tsx'

/** Buttons for the tools of the pointer, and the toggle that mirrors changes. */
export function Toolbar({ model: { tools, session, viewer } }: { model: PanelModel }) {
  const hasDocument = session.document.value !== null
  const { avatar } = viewer.value ?? {}
  // Only the camera works on a skin that cannot wrinkle.
  const names = avatar && avatar.skins[avatar.skin].problem !== null ? (['select'] as const) : TOOL_NAMES
  return (
    <div role="toolbar" aria-label={PAGE.tools} aria-orientation="vertical">
      {names.map((tool) => (
        <ToolButton
          key={tool}
          label={TOOLS[tool]}
          icon={tool}
          shortcut={SHORTCUTS.tools[tool][0].toUpperCase()}
          isPressed={tools.tool.value === tool}
          isDisabled={!hasDocument && tool !== 'select'}
          onPress={() => tools.choose(tool)}
        />
      ))}
      {names === TOOL_NAMES && (
        <ToolButton
          label={TOOLS.mirror}
          icon="mirror"
          shortcut={SHORTCUTS.tools.mirror[0].toUpperCase()}
          isPressed={tools.mirror.value}
          isDisabled={!hasDocument}
          onPress={() => {
            tools.mirror.value = !tools.mirror.peek()
          }}
        />
      )}
    </div>
  )
}

// Generates pages with the options of each command, from the same definitions as `--help`.

import { mkdirSync, readdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { ROOT } from '../../scripts/lib/run.mjs'

const COMMANDS = ['commands', 'batch/commands'].map((folder) => join(ROOT, 'packages/cli/dist', folder))

/** Writes one page per command, and a page that lists the commands. */
export async function gatherCommands(folder) {
  const commands = await readCommands()
  mkdirSync(join(folder, 'commands'), { recursive: true })
  for (const command of commands) {
    writeFileSync(join(folder, 'commands', `${command.name()}.md`), page(command))
  }
  const rows = commands.map((command) => {
    return `| [\`furrow ${command.name()}\`](${command.name()}.md) | ${text(command.description())} |`
  })
  const index = [
    '# Commands',
    INTRODUCTION,
    ['| command | what it does |', '| --- | --- |', ...rows].join('\n'),
  ]
  writeFileSync(join(folder, 'commands/index.md'), `${index.join('\n\n')}\n`)
}

const INTRODUCTION =
  'These pages contain the output of `npx furrow help COMMAND`. `npx furrow` runs a command if `furrow-cli` is installed; otherwise use `npx --yes furrow-cli`.'

export async function readCommands() {
  const files = COMMANDS.flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)))
  const scripts = files.filter((file) => file.endsWith('.js'))
  const modules = await Promise.all(scripts.map((file) => import(pathToFileURL(file).href)))
  return modules
    .flatMap((module) => Object.values(module))
    .filter((value) => typeof value?.createHelp === 'function')
    .sort((a, b) => (a.name() < b.name() ? -1 : 1))
}

function page(command) {
  const help = command.createHelp()
  const options = help.visibleOptions(command)
  const argumentsOf = command.registeredArguments
  return `${[
    `# furrow ${command.name()}`,
    asSentence(command.description()),
    fence('sh', `npx furrow ${command.name()} ${command.usage()}`),
    ...section(
      'Arguments',
      ['argument', ''],
      argumentsOf.map((argument) => [argument.name(), help.argumentDescription(argument)]),
    ),
    ...section(
      'Options',
      ['option', ''],
      options.map((option) => [option.flags, help.optionDescription(option)]),
    ),
    ...notes(command),
  ].join('\n\n')}\n`
}

function section(title, heads, rows) {
  if (rows.length === 0) return []
  const lines = rows.map(
    ([flags, description]) => `| \`${flags.replaceAll('|', '\\|')}\` | ${text(description)} |`,
  )
  return [`## ${title}`, [`| ${heads.join(' | ')} |`, '| --- | --- |', ...lines].join('\n')]
}

/**
 * Converts the help text below the options to Markdown. Paragraphs become paragraphs, and examples become a code block.
 */
function notes(command) {
  let written = ''
  command.emit('afterHelp', { command, error: false, write: (more) => (written += more) })
  const blocks = written.trim().split(/\n{2,}/)
  return blocks.filter(Boolean).flatMap((block) => {
    const [first, ...lines] = block.split('\n')
    if (first === 'Examples:') return ['## Examples', fence('sh', lines.map(withoutPrompt).join('\n'))]
    // A code block keeps the alignment of lists and tables.
    if (lines.some((line) => line.startsWith('  '))) return [fence('text', block)]
    return [text(block.replaceAll('\n', ' '))]
  })
}

const withoutPrompt = (line) => line.replace(/^ *\$ furrow/, 'npx furrow').trimStart()
const fence = (language, content) => `\`\`\`${language}\n${content}\n\`\`\``
const asSentence = (description) => `${text(description.charAt(0).toUpperCase() + description.slice(1))}.`

function text(plain) {
  return plain.replace(/[\\`*_{}[\]<>|#]/g, (character) => `\\${character}`)
}

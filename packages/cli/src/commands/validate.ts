import { checkWrinkles, type Finding, runKhronosValidator, VALIDATOR_FAILED } from 'furrow-files'
import { type ReadOptions, readGlbFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { allowOutsideOption } from '../options.ts'
import { print } from '../print.ts'

const WHO = 'furrow validate'

interface Options extends ReadOptions {
  all?: boolean
  json?: boolean
}

export const validateCommand = createCommand('validate')
  .description('check the wrinkles and the glTF of a face')
  .argument('<face>', 'face with wrinkles (.glb, .vrm, .gltf)')
  .option('--all', 'list problems outside the wrinkles (default: count them)')
  .addOption(allowOutsideOption())
  .option('--json', 'print all findings as JSON')
  .addHelpText(
    'after',
    `
The Khronos validator checks the glTF. The exit code is 1 if there are errors
anywhere in the file. If it is 0, Furrow's loader shows the wrinkles.

Examples:
  $ furrow validate wrinkled.glb
  $ furrow validate wrinkled.glb --all`,
  )
  .action(validate)

async function validate(path: string, { all = false, json = false, ...options }: Options): Promise<void> {
  const glb = await readGlbFile(path, WHO, options)
  const own = await checkWrinkles(glb)
  const others = await runKhronosValidator(glb)
  const findings = [...own, ...others]
  const errors = findings.filter(isError).length
  const warnings = findings.length - errors
  if (errors > 0) process.exitCode = 1
  const rest = all ? [] : others.filter(({ code }) => code !== VALIDATOR_FAILED)
  const listed = findings.filter((finding) => !rest.includes(finding))
  const lines = json
    ? JSON.stringify({ file: path, errors, warnings, findings })
    : [
        ...listed.map(findingText),
        ...sumUp(rest, 'error'),
        ...sumUp(rest, 'warning'),
        `${path}: ${counted(errors, 'error')}, ${counted(warnings, 'warning')}`,
      ]
  print(lines)
}

const isError = ({ severity }: Finding) => severity === 'error'

function findingText({ severity, code, message, pointer }: Finding): string {
  return `${severity}: ${pointer ? `${pointer}: ` : ''}${message} (${code})`
}

/** Summarises findings outside the wrinkles in one line, because most files have such findings. */
function sumUp(findings: readonly Finding[], severity: Finding['severity']): string[] {
  const counts = new Map<string, number>()
  const chosen = findings.filter((finding) => finding.severity === severity)
  for (const { code } of chosen) counts.set(code, (counts.get(code) ?? 0) + 1)
  if (chosen.length === 0) return []
  const codes = [...counts].map(([code, count]) => `${count} ${code}`).join(', ')
  return [`${counted(chosen.length, severity)} outside the wrinkles: ${codes}; list them with --all`]
}

function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? '' : 's'}`
}

import { checkWrinkles, type Finding, GAVE_UP, runKhronosValidator } from 'furrow-files'
import { type ReadOptions, readGlbFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { allowOutsideOption } from '../options.ts'
import { print } from '../print.ts'

const WHO = 'furrow validate'

interface Options extends ReadOptions {
  all?: boolean
  json?: boolean
}

/** `furrow validate`: checks a file. */
export const validateCommand = createCommand('validate')
  .description(
    'check the wrinkles of a face by the rules of the extension, and the file with the Khronos validator',
  )
  .argument('<face>', 'a face with wrinkles (.glb, .vrm, .gltf)')
  .option('--all', 'list what is wrong with the rest of the file too, instead of counting it')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON, with all that was found')
  .addHelpText(
    'after',
    `
The exit code is 0 if there are no errors, with or without warnings: then furrow's loader shows the wrinkles. It is 1 if there are
errors, also about the rest of the file, or the file cannot be read.

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
  const rest = all ? [] : others.filter(({ code }) => code !== GAVE_UP)
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

/** Errors or warnings about what is not wrinkles, as one line: most files have some, and they say nothing about wrinkles. */
function sumUp(findings: readonly Finding[], severity: Finding['severity']): string[] {
  const counts = new Map<string, number>()
  const chosen = findings.filter((finding) => finding.severity === severity)
  for (const { code } of chosen) counts.set(code, (counts.get(code) ?? 0) + 1)
  if (chosen.length === 0) return []
  const codes = [...counts].map(([code, count]) => `${count} ${code}`).join(', ')
  const what = `${counted(chosen.length, severity)} about the rest of the file, not the wrinkles`
  return [`${what}: ${codes}; list them with --all`]
}

function counted(count: number, what: string): string {
  return `${count} ${what}${count === 1 ? '' : 's'}`
}

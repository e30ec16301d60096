import { validateBytes } from 'gltf-validator'
import { normalised } from '../base/references.ts'
import type { ValidatorOutcome, ValidatorTask } from './validator-task.ts'

const report = (outcome: ValidatorOutcome) => postMessage(outcome)

addEventListener('unhandledrejection', ({ reason }) => report({ failure: String(reason) }))
addEventListener('message', async ({ data }: MessageEvent<ValidatorTask>) => {
  const { bytes, files, maxIssues } = data
  const externalResourceFunction = async (uri: string) => files.get(normalised(decodeURIComponent(uri)))!
  const { issues } = await validateBytes(bytes, { maxIssues, externalResourceFunction })
  report({ issues: issues.messages })
})

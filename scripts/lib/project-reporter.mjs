import { writeFileSync } from 'node:fs'
import { relative } from 'node:path'
import { ROOT } from './run.mjs'

/**
 * Vitest reporter for scripts/test.mjs. Writes counts as JSON to the path in FURROW_TEST_REPORT: `{ passed, failed,
 * skipped, failedFiles, isCutOff }`. `skipped` lists tests, and `failedFiles` lists files.
 *
 * Cancels the run at the time in FURROW_TEST_UNTIL (Unix time, milliseconds). The remaining tests count as skipped, not
 * as failed.
 */
export default class ProjectReporter {
  #counts = { passed: 0, failed: 0, skipped: [], failedFiles: [] }
  #timer

  onInit(vitest) {
    const until = Number(process.env.FURROW_TEST_UNTIL)
    if (!until) return
    this.#timer = setTimeout(() => vitest.cancelCurrentRun('keyboard-input'), until - Date.now()).unref()
  }

  onTestModuleEnd(module) {
    const counts = this.#counts
    const file = relative(ROOT, module.moduleId)
    let failed = module.errors().length
    // A file that could not be loaded has no tests, so it counts as one failure.
    if (failed > 0) counts.failed++
    for (const test of module.children.allTests()) {
      const { state } = test.result()
      if (state === 'passed') counts.passed++
      else if (state === 'failed') counts.failed++
      else counts.skipped.push(`${file}: ${test.fullName}`)
      if (state === 'failed') failed++
    }
    if (failed > 0) counts.failedFiles.push(file)
  }

  onTestRunEnd(_modules, errors, reason) {
    clearTimeout(this.#timer)
    const counts = this.#counts
    const isCutOff = reason === 'interrupted' && errors.length === 0 && counts.failed === 0
    writeFileSync(process.env.FURROW_TEST_REPORT, JSON.stringify({ ...counts, isCutOff }))
  }
}

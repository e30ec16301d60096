import { writeFileSync } from 'node:fs'
import { relative } from 'node:path'
import { ROOT } from './run.mjs'

/**
 * A reporter of Vitest: writes what became of each project's tests, as JSON, to the file named by FURROW_TEST_REPORT:
 * `{ name, files, passed, failed, leftOut, seconds }[]`, where `leftOut` lists names, and `seconds` is from the start of the
 * project's first file to the end of its last.
 */
export default class ProjectReporter {
  #projects = new Map()

  onTestModuleStart(module) {
    const name = nameOf(module.project)
    if (this.#projects.has(name)) return
    this.#projects.set(name, { name, files: 0, passed: 0, failed: 0, leftOut: [], start: performance.now() })
  }

  onTestModuleEnd(module) {
    const project = this.#projects.get(nameOf(module.project))
    project.files++
    project.end = performance.now()
    // A file that failed to load has no tests.
    if (module.errors().length > 0) project.failed++
    for (const test of module.children.allTests()) {
      const { state } = test.result()
      if (state === 'passed' || state === 'failed') project[state]++
      else project.leftOut.push(`${relative(ROOT, module.moduleId)}: ${test.fullName}`)
    }
  }

  onTestRunEnd() {
    const projects = [...this.#projects.values()].map(({ start, end, ...counts }) => ({
      ...counts,
      seconds: (end - start) / 1000,
    }))
    writeFileSync(process.env.FURROW_TEST_REPORT, JSON.stringify(projects))
  }
}

/** Without the browser, which Vitest adds: `gpu (chromium)`. */
function nameOf({ name }) {
  return name.replace(/ \(.*\)$/, '')
}

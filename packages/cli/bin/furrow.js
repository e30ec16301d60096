#!/usr/bin/env node
import { existsSync } from 'node:fs'

const main = new URL('../dist/main.js', import.meta.url)
if (existsSync(main)) {
  await import(main)
} else {
  // The published package contains dist/. In a clone it is missing until the first build.
  console.error('furrow: not built yet; run "npm run build" in the root of the repository')
  process.exitCode = 1
}

import { defineConfig } from 'vite'

const conditions = ['furrow-source', 'module', 'node', 'development|production']

/**
 * Builds the commands into dist/, module by module as in src/, and with them the modules of `furrow` and `furrow-files`
 * that they use: the package then needs no copy of either beside it. All other packages stay dependencies. The processes of a batch have
 * an entry of their own.
 */
export default defineConfig({
  logLevel: 'warn',
  ssr: { noExternal: ['furrow', 'furrow-files'], resolve: { conditions } },
  build: {
    ssr: true,
    target: 'node20.19',
    sourcemap: true,
    rolldownOptions: {
      input: ['src/main.ts', 'src/batch/processes/job-process.ts'],
      output: { preserveModules: true, preserveModulesRoot: 'src', entryFileNames: '[name].js' },
    },
  },
})

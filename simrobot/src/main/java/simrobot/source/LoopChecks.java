package simrobot.source;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.DoWhileLoopTree;
import com.sun.source.tree.EnhancedForLoopTree;
import com.sun.source.tree.ForLoopTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.WhileLoopTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;

/**
 * Inserts a check into each loop of a source, so that an interrupted thread leaves it: Java cannot end a computing
 * thread. Line numbers do not change. A source with a syntax error is left to the compiler.
 */
final class LoopChecks {
    /** Throws an error, because a student's catch of exceptions would keep the loop running. */
    private static final String BEFORE =
            "{if(java.lang.Thread.currentThread().isInterrupted())throw new java.lang.Error(\"ended\");";

    private static final String AFTER = "}";

    private LoopChecks() {}

    static String in(JavaCompiler compiler, BehaviourCompiler.Source source) throws IOException {
        String text = source.getCharContent(true).toString();
        DiagnosticCollector<JavaFileObject> found = new DiagnosticCollector<>();
        if (!(compiler.getTask(null, null, found, List.of("-proc:none"), null, List.of(source))
                instanceof JavacTask task)) {
            return text;
        }
        Map<Long, StringBuilder> insertions = new TreeMap<>();
        for (CompilationUnitTree unit : task.parse()) {
            if (found.getDiagnostics().isEmpty()) {
                new Loops(unit, Trees.instance(task).getSourcePositions(), insertions).scan(unit, null);
            }
        }
        return inserted(text, insertions);
    }

    private static String inserted(String text, Map<Long, StringBuilder> insertions) {
        StringBuilder result = new StringBuilder();
        int from = 0;
        for (Map.Entry<Long, StringBuilder> insertion : insertions.entrySet()) {
            int at = insertion.getKey().intValue();
            result.append(text, from, at).append(insertion.getValue());
            from = at;
        }
        return result.append(text, from, text.length()).toString();
    }

    /** Collects the insertions for all loop bodies, the outer ones first. */
    private static final class Loops extends TreeScanner<Void, Void> {
        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final Map<Long, StringBuilder> insertions;

        Loops(CompilationUnitTree unit, SourcePositions positions, Map<Long, StringBuilder> insertions) {
            this.unit = unit;
            this.positions = positions;
            this.insertions = insertions;
        }

        private void check(StatementTree body) {
            long start = positions.getStartPosition(unit, body);
            long end = positions.getEndPosition(unit, body);
            if (start >= 0 && end > start) {
                insertions.computeIfAbsent(start, at -> new StringBuilder()).append(BEFORE);
                insertions.computeIfAbsent(end, at -> new StringBuilder()).insert(0, AFTER);
            }
        }

        @Override
        public Void visitWhileLoop(WhileLoopTree loop, Void none) {
            check(loop.getStatement());
            return super.visitWhileLoop(loop, none);
        }

        @Override
        public Void visitDoWhileLoop(DoWhileLoopTree loop, Void none) {
            check(loop.getStatement());
            return super.visitDoWhileLoop(loop, none);
        }

        @Override
        public Void visitForLoop(ForLoopTree loop, Void none) {
            check(loop.getStatement());
            return super.visitForLoop(loop, none);
        }

        @Override
        public Void visitEnhancedForLoop(EnhancedForLoopTree loop, Void none) {
            check(loop.getStatement());
            return super.visitEnhancedForLoop(loop, none);
        }
    }
}

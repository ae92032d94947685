package simrobot.source;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import simrobot.behaviour.Behaviour;

/** Compiles a source file, and the files of its folder that it uses, to classes in memory. */
final class BehaviourCompiler {
    private static final int MOST_ERRORS = 10;

    /** The compiler's code of a missing brace, which it notices at the end of the file. */
    private static final String MISSING_BRACE = "premature.eof";

    /** The code of an import that finds nothing, whose hint fits a file without any import, too. */
    private static final String MISSING_IMPORT = "doesnt.exist";

    private static final Pattern OWN_CLASS =
            Pattern.compile("symbol: +(class|variable) (Behaviour|Senses|Steering)\\b");

    private final JavaCompiler compiler;
    private final Hints hints;

    /** @param compiler null on a Java without a compiler */
    BehaviourCompiler(JavaCompiler compiler, Hints hints) {
        this.hints = hints;
        this.compiler = compiler;
    }

    /**
     * Compiles one file.
     *
     * @return the classes by their names
     * @throws SourceException with at most 10 compiler errors and the line of the first
     */
    Map<String, byte[]> compile(Path file, String source) throws SourceException {
        if (compiler == null) {
            throw new SourceException(
                    0, "this Java has no compiler, expected a JDK: start SimRobot with the java of a JDK, 17 or newer");
        }
        DiagnosticCollector<JavaFileObject> found = new DiagnosticCollector<>();
        Map<String, byte[]> classes = new TreeMap<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(found, Locale.ENGLISH, null)) {
            Memory memory = new Memory(files, classes);
            List<String> options = List.of(
                    "-proc:none",
                    "-g",
                    "-nowarn",
                    "-classpath",
                    ownClasses(),
                    "-sourcepath",
                    file.toAbsolutePath().getParent().toString());
            boolean done = compiler.getTask(null, memory, found, options, null, List.of(new Source(file, source)))
                    .call();
            if (!done) {
                throw fault(found, file, SourceLines.of(source));
            }
        } catch (IOException e) {
            throw new SourceException(0, "cannot be read: " + e.getMessage());
        }
        return classes;
    }

    /** Each error has its line; a hint is given once. */
    private SourceException fault(DiagnosticCollector<JavaFileObject> found, Path file, SourceLines lines) {
        List<Diagnostic<? extends JavaFileObject>> errors = found.getDiagnostics().stream()
                .filter(each -> each.getKind() == Diagnostic.Kind.ERROR)
                .limit(MOST_ERRORS)
                .toList();
        if (errors.isEmpty()) {
            return new SourceException(0, "cannot be compiled");
        }
        String name = file.getFileName().toString();
        Set<String> causes = new HashSet<>();
        StringBuilder text = new StringBuilder();
        for (Diagnostic<? extends JavaFileObject> error : errors) {
            text.append(text.isEmpty() ? "" : " | line " + error.getLineNumber() + ": ");
            String told = text(error, name);
            String cause = OWN_CLASS.matcher(told).find()
                    ? MISSING_IMPORT
                    : error.getCode().replaceFirst("^compiler\\.err\\.", "");
            text.append(causes.add(cause) ? hints.with(told, cause) : told);
        }
        boolean isBrace = causes.contains(MISSING_BRACE) && lines.unclosed() > 0;
        long line = isBrace ? lines.unclosed() : errors.get(0).getLineNumber();
        return new SourceException((int) Math.max(0, line), text.toString());
    }

    /** @param name of the compiled file; omitted from errors in it */
    private static String text(Diagnostic<? extends JavaFileObject> error, String name) {
        String text =
                error.getMessage(Locale.ENGLISH).lines().map(String::strip).collect(Collectors.joining("; "));
        JavaFileObject source = error.getSource();
        String where = source == null ? name : lastPart(source.toUri());
        return where.equals(name) ? text : where + ": " + text;
    }

    /** The name of a file, also of one in a jar. */
    private static String lastPart(URI place) {
        String path = place.getSchemeSpecificPart();
        return path.substring(path.lastIndexOf('/') + 1);
    }

    /** The location of the compiled interface {@link Behaviour}. */
    static String ownClasses() {
        try {
            return Path.of(Behaviour.class
                            .getProtectionDomain()
                            .getCodeSource()
                            .getLocation()
                            .toURI())
                    .toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException("no place of SimRobot's own classes", e);
        }
    }

    /** A source file held in memory. */
    private static final class Source extends SimpleJavaFileObject {
        private final String text;

        Source(Path file, String text) {
            super(file.toAbsolutePath().toUri(), Kind.SOURCE);
            this.text = text;
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return text;
        }
    }

    /** Keeps compiled classes in memory. */
    private static final class Memory extends ForwardingJavaFileManager<JavaFileManager> {
        private final Map<String, byte[]> classes;

        Memory(JavaFileManager files, Map<String, byte[]> classes) {
            super(files);
            this.classes = classes;
        }

        @Override
        public JavaFileObject getJavaFileForOutput(
                Location location, String className, JavaFileObject.Kind kind, FileObject sibling) {
            URI name = URI.create("memory:///" + className.replace('.', '/') + kind.extension);
            return new SimpleJavaFileObject(name, kind) {
                @Override
                public OutputStream openOutputStream() {
                    return new ByteArrayOutputStream() {
                        @Override
                        public void close() {
                            classes.put(className, toByteArray());
                        }
                    };
                }
            };
        }
    }
}

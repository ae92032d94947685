package simgsm.modem.at;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** The commands of a modem by name. It prints itself as the manual's list of commands. */
public final class AtCommandTable<C> {
    /** One command with its forms. */
    public static final class Row<C> {
        private final String name;
        private final String parameters;
        private final String meaning;
        private String ranges = "";
        private Optional<String> initial = Optional.empty();
        private final Map<AtCommand.Form, AtHandler<C>> handlers = new EnumMap<>(AtCommand.Form.class);

        Row(String name, String parameters, String meaning) {
            this.name = name;
            this.parameters = parameters;
            this.meaning = meaning;
        }

        private Row<C> on(AtCommand.Form form, AtHandler<C> handler) {
            handlers.put(form, handler);
            return this;
        }

        private static <C> AtHandler<C> ending(AtHandler.Simple<C> simple) {
            return (client, request) -> {
                simple.perform(client, request);
                return AtResult.OK;
            };
        }

        /** The form without parameters, the only one of a basic command. */
        public Row<C> executeFor(AtHandler<C> handler) {
            return on(AtCommand.Form.EXECUTE, handler);
        }

        public Row<C> execute(AtHandler.Simple<C> handler) {
            return executeFor(ending(handler));
        }

        public Row<C> read(AtHandler.Simple<C> handler) {
            return on(AtCommand.Form.READ, ending(handler));
        }

        public Row<C> setFor(AtHandler<C> handler) {
            return on(AtCommand.Form.SET, handler);
        }

        public Row<C> set(AtHandler.Simple<C> handler) {
            return setFor(ending(handler));
        }

        /** The answer to the test form, after the command's name. */
        public Row<C> test(String values) {
            ranges = values;
            return on(AtCommand.Form.TEST, ending((client, request) -> request.answer(values)));
        }

        /** A test form with an answer that depends on the state. */
        public Row<C> testWith(AtHandler.Simple<C> handler) {
            return on(AtCommand.Form.TEST, ending(handler));
        }

        Optional<AtHandler<C>> handler(AtCommand.Form form) {
            AtHandler<C> handler = handlers.get(form);
            boolean isTested = handler == null && form == AtCommand.Form.TEST && name.length() > 2;
            return isTested ? Optional.of((client, request) -> AtResult.OK) : Optional.ofNullable(handler);
        }

        public String name() {
            return name;
        }

        /** The answer to the test form; empty if it has none, or depends on the state. */
        public String ranges() {
            return ranges;
        }

        /** Initial values of a command that only stores its numbers. */
        public Optional<String> initial() {
            return initial;
        }

        /** The forms as typed, such as {@code AT+CSQ AT+CSQ=?}. */
        String forms() {
            List<String> forms = new ArrayList<>();
            for (AtCommand.Form form : handlers.keySet()) {
                forms.add("AT" + name
                        + switch (form) {
                            case EXECUTE -> name.length() > 2 ? "" : parameters;
                            case READ -> "?";
                            case TEST -> "=?";
                            case SET -> "=" + parameters;
                        });
            }
            return String.join(" ", forms);
        }
    }

    private final Map<String, Row<C>> rows = new LinkedHashMap<>();

    /** A table without commands. */
    AtCommandTable() {}

    /**
     * A table with a row for each block of text: the name, and the parameters of SET or of a basic command; then
     * indented {@code test:} with the answer to the test form, {@code kept:} with the initial values of a command
     * that only stores its numbers, and the meaning.
     */
    public AtCommandTable(Stream<String> blocks) {
        blocks.forEach(block -> add(block.strip().split("\n *")));
    }

    private void add(String[] block) {
        String[] head = block[0].split(" ", 2);
        Optional<String> test = field(block, "test: ");
        Optional<String> kept = field(block, "kept: ");
        String meaning = block[block.length - 1]
                + kept.map(initial -> " (" + initial + ")").orElse("");
        String parameters = kept.isPresent()
                ? test.orElseThrow().replaceAll("(\\d),(?=\\d)", "$1|").replaceAll("[()]", "")
                : head.length > 1 ? head[1] : "";
        Row<C> row = add(head[0], parameters, meaning);
        row.initial = kept;
        test.ifPresent(row::test);
    }

    private static Optional<String> field(String[] block, String name) {
        return Stream.of(block)
                .filter(line -> line.startsWith(name))
                .map(line -> line.substring(name.length()))
                .findFirst();
    }

    /** Adds a command. @param parameters of SET, or of a basic command, as in the manual */
    Row<C> add(String name, String parameters, String meaning) {
        Row<C> row = new Row<>(name, parameters, meaning);
        if (rows.put(name, row) != null) {
            throw new IllegalArgumentException("AT" + name + " is twice in the table");
        }
        return row;
    }

    /** The row of an existing command. */
    public Row<C> row(String name) {
        return Objects.requireNonNull(rows.get(name), name);
    }

    public Collection<Row<C>> rows() {
        return rows.values();
    }

    Optional<AtHandler<C>> handler(AtCommand command) {
        return Optional.ofNullable(rows.get(command.name())).flatMap(row -> row.handler(command.form()));
    }

    /** The commands as a list in Markdown. */
    public String toMarkdown() {
        StringBuilder text = new StringBuilder();
        for (Row<C> row : rows.values()) {
            text.append("- `%s`: %s\n".formatted(row.forms(), row.meaning));
        }
        return text.toString();
    }
}

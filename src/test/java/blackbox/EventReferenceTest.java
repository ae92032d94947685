package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simgsm.console.Event;
import simgsm.event.EventForm;
import simgsm.event.EventLine;
import simgsm.octets.OctetString;
import simgsm.web.JsonText;
import simrobot.process.BehaviourKind;

/** Every record with an {@link EventLine} is printed, is JSON, has its row in the reference, and can be met in a lesson. */
class EventReferenceTest {
    /** Packages of each program's events, in the order of the page. */
    private static final Map<String, String> SECTIONS = new LinkedHashMap<>();

    static {
        SECTIONS.put("Phone", "simgsm\\.(station|phone)\\..*");
        SECTIONS.put("SimRobot", "(simrobot|simgsm\\.modem)\\..*");
        SECTIONS.put("Centre", "simgsm\\.center\\..*");
        SECTIONS.put("Cells", "simgsm\\.cells\\..*");
        SECTIONS.put("Gateway", "simgsm\\.gateway\\..*");
    }

    /** Fields of classes that only a running network has; {@link CellsConsoleTest} reads their lines. */
    private static final Set<String> OF_A_NETWORK = Set.of(
            "camped",
            "cipher",
            "cipher-mismatch",
            "location-update",
            "report",
            "handover",
            "speech-gap",
            "radio-link-failure",
            "mobile",
            "cell",
            "placed");

    private static final Pattern DECLARED = Pattern.compile(
            "/\\*\\*((?:(?!\\*/).)*)\\*/\\s*@EventLine\\(((?:\\s*\\+?\\s*\"[^\"]*\")+)\\s*\\)\\s*"
                    + "(?:public )?(?:final )?(?:record|class) (\\w+)",
            Pattern.DOTALL);

    private record Row(String packageName, String className, String line, String text) {
        String name() {
            return line.split(" ")[0];
        }

        /** The line without the paths of its values. */
        String usage() {
            return line.replaceAll("=[A-Za-z0-9.:]+", "=");
        }
    }

    /** All declarations as the sources have them. */
    private static List<Row> rows() {
        Map<String, Row> rows = new LinkedHashMap<>();
        for (Path file : MainCode.sources()) {
            String source = MainCode.read(file);
            Matcher packageName = Pattern.compile("(?m)^package (.+);").matcher(source);
            Matcher found = DECLARED.matcher(source);
            while (found.find()) {
                String line = found.group(2).replaceAll("\"\\s*\\+\\s*\"", "").replaceAll("^\\s*\"|\"\\s*$", "");
                assertTrue(packageName.find(0));
                rows.put(
                        found.group(3),
                        new Row(
                                packageName.group(1),
                                found.group(3),
                                line,
                                found.group(1).replaceAll("\\s*\n\\s*\\* ?", " ")));
            }
        }
        return List.copyOf(rows.values());
    }

    private static List<Class<?>> classes() {
        return MainCode.CLASSES.stream()
                .filter(type -> type.isAnnotatedWith(EventLine.class))
                .<Class<?>>map(JavaClass::reflect)
                .toList();
    }

    @Test
    void everyKindHasItsRowInTheReference() throws Exception {
        List<Row> rows = rows();
        assertEquals(
                classes().stream().map(Class::getSimpleName).sorted().toList(),
                rows.stream().map(Row::className).sorted().toList(),
                "each has a comment directly before @EventLine");
        Path file = Dist.root().resolve("docs/CONSOLE.md");
        String page = Files.readString(file).replace("\r", "");
        StringBuilder printed = new StringBuilder(page.substring(0, page.indexOf("### Phone")));
        Set<Row> left = new LinkedHashSet<>(rows);
        SECTIONS.forEach((program, packages) -> {
            printed.append("### ").append(program).append("\n\n");
            for (Row row : rows) {
                if ((row.packageName() + ".").matches(packages)) {
                    assertTrue(left.remove(row));
                    printed.append("- `")
                            .append(row.usage())
                            .append("`: ")
                            .append(text(row, rows))
                            .append('\n');
                }
            }
            printed.append('\n');
        });
        assertEquals(Set.of(), left);
        PrintedFile.hold(
                file,
                printed.append(page.substring(page.indexOf("## Exit statuses"))).toString());
    }

    /** The paragraph about the line, or the whole comment, without its tags. */
    private static String text(Row row, List<Row> rows) {
        String text = row.text()
                .replaceFirst(".*<p>As a line: ", "")
                .replaceFirst("\\s+@param.*", "")
                .strip();
        text = text.replaceAll("\\{@code ([^}]*)}", "`$1`");
        Matcher link = Pattern.compile("\\{@link (\\w+)}").matcher(text);
        text = link.replaceAll(found -> rows.stream()
                .filter(each -> each.className().equals(found.group(1)))
                .map(each -> "`" + each.name() + "`")
                .findFirst()
                .orElseThrow());
        assertFalse(text.isEmpty() || text.contains("{@"), row + ": " + text);
        return text.substring(0, 1).toLowerCase() + text.substring(1).replaceFirst("\\.$", "");
    }

    @Test
    void everyKindIsPrintedReadBackAndWrittenAsJson() throws Exception {
        Map<String, Object> given = Map.of("robot", "robot", "state", "accepted", "meaning", "executed");
        Set<String> ofANetwork = new TreeSet<>();
        for (Class<?> type : classes()) {
            EventForm form = EventForm.of(type);
            if (OF_A_NETWORK.contains(form.name()) && type.getName().startsWith("simgsm.cells.")) {
                ofANetwork.add(form.name());
                continue;
            }
            Object sample = sample(type);
            Event event = Event.from(sample, given);
            assertEquals(event, Event.parse(event.toString()));
            assertTrue(event.toString().startsWith(form.name()), event.toString());
            String json = new JsonText().object(form.values(sample, given)).toString();
            event.fields().keySet().forEach(key -> assertTrue(json.contains('"' + key + "\":"), json));
        }
        assertEquals(new TreeSet<>(OF_A_NETWORK), ofANetwork);
    }

    private static final List<Object> VALUES = List.of(
            1,
            1L,
            1.5,
            true,
            '1',
            "123456789012345",
            Instant.EPOCH,
            Duration.ofMinutes(1),
            OffsetDateTime.parse("2026-11-21T12:00:00Z"),
            Path.of("file"),
            OptionalInt.of(1),
            OctetString.of(new byte[0]),
            BehaviourKind.WANDER);

    private static final Map<Class<?>, Class<?>> BOXES = Map.of(
            int.class,
            Integer.class,
            long.class,
            Long.class,
            double.class,
            Double.class,
            boolean.class,
            Boolean.class,
            char.class,
            Character.class);

    /** An instance with some values. */
    private static Object sample(Type type) {
        if (type instanceof ParameterizedType of) {
            Object element = sample(of.getActualTypeArguments()[0]);
            return of.getRawType() == Optional.class ? Optional.of(element) : List.of(element);
        }
        Class<?> raw = BOXES.getOrDefault(type, (Class<?>) type);
        if (raw.isEnum()) {
            return raw.getEnumConstants()[0];
        }
        if (!raw.isRecord()) {
            return VALUES.stream().filter(raw::isInstance).findFirst().orElseThrow(() -> new AssertionError(type));
        }
        try {
            RecordComponent[] components = raw.getRecordComponents();
            var constructor = raw.getDeclaredConstructor(
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
            constructor.setAccessible(true);
            return constructor.newInstance(Arrays.stream(components)
                    .map(component -> sample(component.getGenericType()))
                    .toArray());
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(type.toString(), e);
        }
    }

    private static final Map<String, String> SOURCES =
            Map.of("simgsm-phone", "Phone", "simrobot", "SimRobot", "simgsm-cells", "Cells");

    private static final Pattern PROGRAM = Pattern.compile("(?:program|later) (\\S+) (\\S+).*");
    private static final Pattern CONDITION =
            Pattern.compile("(?:when|then|again|at-(?:least|most) \\S+(?: different \\S+)?) (\\S+) (\\S+)(.*)");

    /** What a lesson waits for is an event that the program prints, with the fields that the record has. */
    @Test
    void conditionsOfLessonsNameEventsAndFieldsThatAreDeclared() throws Exception {
        Map<String, List<Row>> declared = new LinkedHashMap<>();
        Function<Row, String> program = row -> SECTIONS.entrySet().stream()
                .filter(each -> (row.packageName() + ".").matches(each.getValue()))
                .findFirst()
                .orElseThrow()
                .getKey();
        rows().forEach(row -> declared.computeIfAbsent(program.apply(row), none -> new ArrayList<>())
                .add(row));
        List<String> unknown = new ArrayList<>();
        int conditions = 0;
        for (Path lesson : lessons()) {
            Map<String, String> programs = new LinkedHashMap<>(Map.of("centre", "Centre"));
            for (String line : Files.readAllLines(lesson)) {
                Matcher named = PROGRAM.matcher(line);
                if (named.matches()) {
                    programs.put(named.group(1), SOURCES.get(named.group(2)));
                }
                Matcher condition = CONDITION.matcher(line);
                // "at" is the answer to the lesson's own AT command
                if (condition.matches()
                        && programs.containsKey(condition.group(1))
                        && !condition.group(2).equals("at")) {
                    conditions++;
                    if (declared.get(programs.get(condition.group(1))).stream()
                            .noneMatch(row -> row.name().equals(condition.group(2))
                                    && keys(row).containsAll(fields(condition.group(3))))) {
                        unknown.add(lesson.getParent().getFileName() + ": " + line);
                    }
                }
            }
        }
        assertEquals(List.of(), unknown);
        assertTrue(conditions > 40, "conditions: " + conditions);
    }

    private static Set<String> keys(Row row) {
        return Stream.of(row.usage().split(" "))
                .skip(1)
                .map(word -> word.replaceAll("[\\[=\\]]", ""))
                .collect(Collectors.toSet());
    }

    private static Set<String> fields(String tests) {
        return Stream.of(tests.strip().split(" +"))
                .map(test -> test.replaceFirst("[^A-Za-z0-9-].*", ""))
                .filter(field -> !field.isEmpty())
                .collect(Collectors.toSet());
    }

    private static List<Path> lessons() throws Exception {
        List<Path> lessons = new ArrayList<>();
        for (String folder : List.of("simgsm-modem/lesson/src/main/resources/lessons", "docs/lessons")) {
            try (Stream<Path> files = Files.walk(Dist.root().resolve(folder))) {
                files.filter(file -> file.endsWith("lesson.txt")).forEach(lessons::add);
            }
        }
        return lessons;
    }
}

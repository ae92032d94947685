package blackbox.uml;

import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.MainCode;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * Ten class diagrams, each for a question of a reader, printed from the compiled classes: inheritance, the methods of the
 * interfaces, which type holds which (solid) and takes which as a parameter (dashed).
 */
class ClassDiagramsTest {
    /** Question and types, by the file's name. No class name stands twice in the suite. */
    private static final Map<String, List<String>> DIAGRAMS = new TreeMap<>(Map.of(
            "key",
            List.of(
                    "Who decides that a key was heard?",
                    "KeyReceiver DtmfReceiver ClassicReceiver GoertzelBank DigitTracker ToneFit KeyMeasures DtmfGenerator"
                            + " DtmfListener DtmfDigit DtmfKey ReceiverTrace"),
            "order",
            List.of(
                    "Who judges an order, and who executes it?",
                    "VeriCommand CommandRecognizer CommandGrammar Recognition Order Instruction StatusRules StatusMachine"
                            + " OrderExecution Robot Verdict MotionOutcome Reply ReplyTone VeriCommandListener"),
            "motion",
            List.of(
                    "What moves a robot?",
                    "Pioneer SimulatedRobot OrderedMotion MotionProgress DrivenMotion Drive Axis Trapezoid"
                            + " Wheels Floor SimulatedFloor Autonomy Odometry Noise"),
            "world",
            List.of(
                    "What is a world, and what is a kind of item?",
                    "World WorldBuilder WorldItem AreaItem Surface ItemKind ItemField ItemKinds Segment Point Home Box Goal"
                            + " ForbiddenLine ForbiddenArea Treadmill"),
            "message",
            List.of(
                    "Where is a short message while it waits?",
                    "ShortMessageCenter MessageStore MessageRegister ReceiverQueues ReceiverQueue QueueEntry ShortMessage"
                            + " RetrySchedule DeliveryPort DeliveryAttempt StoreEntry MessageHistory"),
            "journal",
            List.of(
                    "How does a message reach the disk?",
                    "JournalThread Journal JournalSegment JournalState Disk DiskFile FileDisk Recovery RecordReader EntryCodec"
                            + " Compaction"),
            "call",
            List.of(
                    "Who connects two legs of a call?",
                    "CallSwitch LinkCalls CallLeg NetworkCall NetworkTones ToneSender KeyTap CallView"),
            "station",
            List.of(
                    "What is a mobile station made of?",
                    "MobileStation StationThread StationContext StationLink MessageDispatcher ConnectionControl"
                            + " MobileRegistration MobileCall SecondCall SpeechPath KeySignalling ShortMessages MobileUssd"),
            "modem",
            List.of(
                    "How does M2 serve an AT client and the robot?",
                    "Modem AnsweringModem ModemEvent Replies AtSession AtLineParser AtCommandTable AtCommand AtHandler"
                            + " AtRequest AtResult"),
            "town",
            List.of(
                    "What stands between a phone and a tower?",
                    "CellNetwork Mobile MobilePort MobileNetwork RadioLink IdleSelection Reception RadioField BaseStation"
                            + " TowerChannel TowerPort Walker")));

    @Test
    void tenQuestionsOfReaders() throws Exception {
        Map<String, JavaClass> types = MainCode.CLASSES.stream()
                .filter(JavaClass::isTopLevelClass)
                .collect(Collectors.toMap(JavaClass::getSimpleName, type -> type, (one, other) -> one));
        Set<String> files = new TreeSet<>();
        for (Map.Entry<String, List<String>> each : DIAGRAMS.entrySet()) {
            List<JavaClass> shown = new ArrayList<>();
            for (String name : each.getValue().get(1).split(" ")) {
                assertTrue(types.containsKey(name), each.getKey() + ": there is no class " + name);
                shown.add(types.get(name));
            }
            String file = "classes-" + each.getKey() + ".puml";
            files.add(file);
            Diagram.hold("design/" + file, diagram(each.getValue().get(0), shown));
        }
        Diagram.holdOnly("design", "classes-", files);
    }

    private static String diagram(String question, List<JavaClass> shown) {
        StringBuilder uml = new StringBuilder(Diagram.head(question));
        uml.append("hide empty members\nhide circle\n");
        shown.forEach(type -> declare(uml, type));
        Set<String> arrows = new TreeSet<>();
        shown.forEach(type -> arrows(type, shown, arrows));
        arrows.forEach(arrow -> uml.append(arrow).append('\n'));
        return uml.append("@enduml\n").toString();
    }

    private static void declare(StringBuilder uml, JavaClass type) {
        uml.append(type.isInterface() ? "interface " : type.isEnum() ? "enum " : "class ")
                .append(type.getSimpleName())
                .append(type.isRecord() ? " <<record>>" : "");
        Set<String> methods = type.isInterface()
                ? type.getMethods().stream()
                        .filter(method -> !method.getModifiers().contains(JavaModifier.STATIC))
                        .filter(method -> !method.getModifiers().contains(JavaModifier.SYNTHETIC))
                        .filter(method -> !method.getModifiers().contains(JavaModifier.PRIVATE))
                        .map(ClassDiagramsTest::signature)
                        .collect(Collectors.toCollection(TreeSet::new))
                : Set.of();
        if (methods.isEmpty()) {
            uml.append('\n');
            return;
        }
        uml.append(" {\n");
        methods.forEach(method -> uml.append("  ").append(method).append('\n'));
        uml.append("}\n");
    }

    private static String signature(JavaMethod method) {
        return method.getName()
                + method.getRawParameterTypes().stream()
                        .map(JavaClass::getSimpleName)
                        .collect(Collectors.joining(", ", "(", ")"));
    }

    private static void arrows(JavaClass type, List<JavaClass> face, Set<String> arrows) {
        type.getRawSuperclass()
                .filter(face::contains)
                .ifPresent(parent -> arrows.add(parent.getSimpleName() + " <|-- " + type.getSimpleName()));
        type.getRawInterfaces().stream()
                .filter(face::contains)
                .forEach(port -> arrows.add(port.getSimpleName() + " <|.. " + type.getSimpleName()));
        Set<JavaClass> held = type.getFields().stream()
                .filter(field -> !field.getModifiers().contains(JavaModifier.STATIC))
                .flatMap(field -> field.getType().getAllInvolvedRawTypes().stream())
                .collect(Collectors.toSet());
        Set<JavaClass> taken = type.getCodeUnits().stream()
                .filter(unit -> unit.getModifiers().contains(JavaModifier.PUBLIC))
                .flatMap(unit -> unit.getParameterTypes().stream())
                .flatMap(parameter -> parameter.getAllInvolvedRawTypes().stream())
                .filter(parameter -> !held.contains(parameter))
                .collect(Collectors.toSet());
        arrows(type, "-->", held, face, arrows);
        arrows(type, "..>", taken, face, arrows);
    }

    private static void arrows(
            JavaClass type, String arrow, Set<JavaClass> used, List<JavaClass> face, Set<String> arrows) {
        used.stream()
                .filter(other -> !other.equals(type) && face.contains(other) && !type.isAssignableTo(other.getName()))
                .forEach(other -> arrows.add(type.getSimpleName() + " " + arrow + " " + other.getSimpleName()));
    }
}

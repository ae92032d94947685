package blackbox;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition;
import com.tngtech.archunit.lang.syntax.elements.GivenClassesConjunction;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The house's arrows point down only, and Swing stays in the windows. */
class LayeringTest {
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .importPaths(Stream.concat(
                            Stream.of("vericommand", "simgsm-center", "simgsm-phone", "simrobot"),
                            Stream.of("base", "air", "sound", "console", "station", "desktop", "tools")
                                    .map("simgsm-modem/"::concat))
                    .map(module -> Dist.root().resolve(module).resolve("target").resolve("classes"))
                    .toList());

    /** Which of our packages each may use, as in the design. */
    private static final Map<String, Set<String>> MAY_USE = Map.ofEntries(
            Map.entry("vericommand", Set.of()),
            Map.entry("simgsm.air", Set.of()),
            Map.entry("simgsm.console", Set.of()),
            Map.entry("simgsm.dtmf", Set.of()),
            Map.entry("simgsm.sms", Set.of("simgsm.air")),
            Map.entry("simgsm.sim", Set.of("simgsm.air", "simgsm.console")),
            Map.entry("simgsm.speech", Set.of()),
            Map.entry(
                    "simgsm.station", Set.of("simgsm.air", "simgsm.sim", "simgsm.sms", "simgsm.dtmf", "simgsm.speech")),
            Map.entry(
                    "simgsm.modem",
                    Set.of(
                            "simgsm.air",
                            "simgsm.sms",
                            "simgsm.dtmf",
                            "simgsm.speech",
                            "simgsm.station",
                            "simgsm.console",
                            "simgsm.modem.tools")),
            Map.entry(
                    "simgsm.modem.tools",
                    Set.of(
                            "simgsm.air",
                            "simgsm.sms",
                            "simgsm.dtmf",
                            "simgsm.speech",
                            "simgsm.console",
                            "simgsm.modem.load",
                            "simgsm.modem.fuzz")),
            Map.entry(
                    "simgsm.modem.fuzz",
                    Set.of("simgsm.speech", "simgsm.air", "simgsm.sms", "simgsm.dtmf", "simgsm.station")),
            Map.entry("simgsm.modem.load", Set.of("simgsm.air", "simgsm.station", "simgsm.console")),
            Map.entry("simgsm.ui", Set.of("simgsm.console", "simgsm.dtmf", "simgsm.speech")));

    @Test
    void sharedPackagesUseOnlyWhatLiesBelowThem() {
        ArchRuleDefinition.classes()
                .should(new ArchCondition<JavaClass>("use only the packages below them") {
                    @Override
                    public void check(JavaClass from, ConditionEvents events) {
                        Set<String> allowed = MAY_USE.get(from.getPackageName());
                        if (allowed == null) {
                            return;
                        }
                        from.getDirectDependenciesFromSelf().stream()
                                .filter(use -> isOurs(use.getTargetClass().getPackageName()))
                                .filter(use ->
                                        !use.getTargetClass().getPackageName().equals(from.getPackageName()))
                                .filter(use ->
                                        !allowed.contains(use.getTargetClass().getPackageName()))
                                .forEach(use -> events.add(SimpleConditionEvent.violated(from, use.getDescription())));
                    }
                })
                .check(CLASSES);
    }

    private static boolean isOurs(String name) {
        return Stream.of("vericommand", "simgsm", "simrobot")
                .anyMatch(root -> name.equals(root) || name.startsWith(root + "."));
    }

    @Test
    void theProgramsDoNotKnowOneAnother() {
        for (List<String> pair : List.of(
                List.of("simgsm.center..", "simgsm.phone.."),
                List.of("simgsm.center..", "simrobot.."),
                List.of("simgsm.phone..", "simrobot.."))) {
            noClasses()
                    .that()
                    .resideInAPackage(pair.get(0))
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage(pair.get(1))
                    .check(CLASSES);
            noClasses()
                    .that()
                    .resideInAPackage(pair.get(1))
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage(pair.get(0))
                    .check(CLASSES);
        }
    }

    @Test
    void packagesHaveNoCircles() {
        for (String root : List.of("simgsm.center", "simgsm.phone", "simrobot")) {
            slices().matching(root + ".(*)..").should().beFreeOfCycles().check(CLASSES);
        }
        slices().matching("simgsm.(*)..").should().beFreeOfCycles().check(CLASSES);
    }

    @Test
    void swingStaysInTheWindowsAndTheMains() {
        noClasses()
                .that()
                .resideOutsideOfPackage("..ui..")
                .and()
                .haveSimpleNameNotEndingWith("Main")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("javax.swing..", "java.awt", "java.awt.event..", "java.awt.geom..")
                .check(CLASSES);
    }

    private static final String[] CORES = {
        "vericommand",
        "simgsm.air",
        "simgsm.sms",
        "simgsm.dtmf",
        "simgsm.station",
        "simgsm.modem",
        "simgsm.center.msc",
        "simgsm.center.smpp",
        "simgsm.center.smsc",
        "simgsm.center.subscriber",
        "simgsm.center.timer",
        "simgsm.phone.handset",
        "simrobot.behaviour",
        "simrobot.robot",
        "simrobot.simulation"
    };

    /** Give the cores beside them their time and their sockets. */
    private static final Set<String> SHELLS =
            Set.of("StationThread", "StationLink", "OutgoingFrames", "SimulationThread");

    private static GivenClassesConjunction coreClasses() {
        return noClasses()
                .that()
                .resideInAnyPackage(CORES)
                .and()
                .haveSimpleNameNotEndingWith("Main")
                .and(DescribedPredicate.describe(
                        "are no shells", (JavaClass each) -> !SHELLS.contains(each.getSimpleName())));
    }

    @Test
    void coresKnowNoClockNoSocketNoFile() {
        coreClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.net..", "java.nio.channels..", "java.nio.file..", "java.io")
                .check(CLASSES);
        coreClasses()
                .should()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .orShould()
                .callMethod(Instant.class, "now")
                .check(CLASSES);
        coreClasses()
                .should()
                .dependOnClassesThat()
                .areAssignableTo(Thread.class)
                .check(CLASSES);
    }
}

package blackbox;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.syntax.elements.GivenClassesConjunction;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleDescriptor.Requires;
import java.lang.module.ModuleFinder;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The arrows between packages and modules: which package may use which, where Swing may be, what a core may not know. */
class LayeringTest {
    /**
     * A row for every package: the packages of the suite that it may use. A row names only packages of rows above it, so
     * the packages have no circles.
     */
    private static final Map<String, Set<String>> MAY_USE = rows("""
            simgsm.event             :
            simgsm.file              :
            simgsm.octets            :
            simgsm.state             :
            simgsm.thread            :
            simgsm.timer             :
            simgsm.net               : simgsm.timer simgsm.thread
            vericommand              : simgsm.state
            simgsm.air               : simgsm.event simgsm.octets
            simgsm.abis              : simgsm.octets simgsm.timer simgsm.net simgsm.air
            simgsm.air.answer        : simgsm.air
            simgsm.rr                : simgsm.octets simgsm.air
            simgsm.sim               : simgsm.file simgsm.octets simgsm.air
            simgsm.sms               : simgsm.octets simgsm.air
            simgsm.smpp              : simgsm.octets simgsm.air simgsm.sms
            simgsm.ss                : simgsm.octets simgsm.air simgsm.sms
            simgsm.trace             : simgsm.octets simgsm.air simgsm.abis simgsm.sms simgsm.ss
            simgsm.speech            :
            simgsm.tone              : simgsm.speech
            simgsm.words             : simgsm.speech simgsm.tone
            simgsm.dtmf              : simgsm.speech simgsm.tone
            simgsm.scope             : simgsm.speech simgsm.tone simgsm.dtmf simgsm.words
            simgsm.console           : simgsm.event simgsm.file simgsm.thread
            simgsm.lesson            : simgsm.file simgsm.console
            simgsm.web               : simgsm.file simgsm.timer simgsm.net simgsm.event simgsm.console simgsm.thread
            simgsm.audio             : simgsm.net simgsm.speech simgsm.thread
            simgsm.draw              :
            simgsm.ui                : simgsm.console simgsm.draw
            simgsm.ui.pane           : simgsm.console simgsm.draw simgsm.ui
            simgsm.ui.file           : simgsm.ui
            simgsm.ui.glossary       : simgsm.console simgsm.draw simgsm.ui simgsm.ui.pane
            simgsm.ui.lesson         : simgsm.console simgsm.draw simgsm.lesson simgsm.ui simgsm.ui.glossary simgsm.ui.pane
            simgsm.ui.scope          : simgsm.console simgsm.draw simgsm.dtmf simgsm.scope simgsm.speech simgsm.tone simgsm.words simgsm.ui simgsm.ui.glossary
            simgsm.ui.window         : simgsm.console simgsm.draw simgsm.file simgsm.lesson simgsm.ui simgsm.ui.file simgsm.ui.glossary simgsm.ui.lesson simgsm.thread
            simgsm.station.context   : simgsm.event simgsm.sms simgsm.octets simgsm.timer simgsm.air simgsm.abis simgsm.sim simgsm.ss simgsm.dtmf
            simgsm.station.mobility  : simgsm.octets simgsm.state simgsm.air simgsm.sim simgsm.station.context
            simgsm.station.call      : simgsm.ss simgsm.state simgsm.air simgsm.air.answer simgsm.abis simgsm.dtmf simgsm.speech simgsm.station.context simgsm.station.mobility
            simgsm.station.sms       : simgsm.octets simgsm.state simgsm.air simgsm.sms simgsm.station.context simgsm.station.mobility simgsm.timer
            simgsm.station.ss        : simgsm.octets simgsm.state simgsm.air simgsm.sms simgsm.ss simgsm.station.context simgsm.station.mobility
            simgsm.station           : simgsm.octets simgsm.net simgsm.timer simgsm.air simgsm.air.answer simgsm.sim simgsm.abis simgsm.rr simgsm.sms simgsm.dtmf simgsm.speech simgsm.station.context simgsm.station.mobility simgsm.station.call simgsm.station.sms simgsm.station.ss
            simgsm.modem             : simgsm.air simgsm.sim simgsm.dtmf simgsm.station simgsm.station.context simgsm.station.mobility simgsm.station.call simgsm.words
            simgsm.modem.at          : simgsm.timer simgsm.dtmf simgsm.speech simgsm.station.call
            simgsm.modem.at.state    : simgsm.octets simgsm.air simgsm.sim simgsm.sms simgsm.station.context
            simgsm.modem.at.sms      : simgsm.modem.at simgsm.modem.at.state simgsm.octets simgsm.air simgsm.sms
            simgsm.modem.at.command  : simgsm.modem simgsm.modem.at.state simgsm.modem.at.sms simgsm.ss simgsm.octets simgsm.timer simgsm.air simgsm.sim simgsm.sms simgsm.dtmf simgsm.station simgsm.station.context simgsm.station.call simgsm.modem.at
            simgsm.modem.at.port     : simgsm.timer simgsm.net simgsm.station simgsm.station.context simgsm.modem.at simgsm.modem.at.command
            simgsm.modem.line        : simgsm.net simgsm.thread
            simgsm.modem.client      : simgsm.modem.line simgsm.event simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.sim simgsm.sms simgsm.dtmf simgsm.speech simgsm.words simgsm.station simgsm.station.call simgsm.station.context simgsm.modem simgsm.modem.at
            simgsm.tools.audio       : simgsm.speech
            simgsm.tools.load        : simgsm.air simgsm.console simgsm.station simgsm.station.context simgsm.station.mobility simgsm.station.call
            simgsm.tools             : simgsm.file simgsm.octets simgsm.air simgsm.sms simgsm.trace simgsm.tone simgsm.dtmf simgsm.speech simgsm.words simgsm.console simgsm.station simgsm.tools.audio simgsm.tools.load
            simgsm.phone.store       : simgsm.event simgsm.air simgsm.sim simgsm.station.context
            simgsm.phone.screen      : simgsm.air simgsm.sim simgsm.ss simgsm.dtmf simgsm.speech simgsm.draw simgsm.station.context simgsm.phone.store
            simgsm.phone.handset     : simgsm.event simgsm.air simgsm.sim simgsm.sms simgsm.ss simgsm.tone simgsm.dtmf simgsm.scope simgsm.speech simgsm.words simgsm.station simgsm.station.context simgsm.phone.store simgsm.phone.screen
            simgsm.phone.ui          : simgsm.ss simgsm.air simgsm.sim simgsm.sms simgsm.tone simgsm.dtmf simgsm.speech simgsm.station simgsm.console simgsm.draw simgsm.ui simgsm.ui.window simgsm.ui.scope simgsm.phone.store simgsm.phone.screen simgsm.phone.handset
            simgsm.phone             : simgsm.file simgsm.octets simgsm.modem.at simgsm.modem.at.command simgsm.modem.at.port simgsm.air simgsm.sim simgsm.sms simgsm.ss simgsm.tone simgsm.dtmf simgsm.speech simgsm.audio simgsm.console simgsm.station simgsm.station.context simgsm.station.mobility simgsm.station.call simgsm.ui.window simgsm.phone.store simgsm.phone.screen simgsm.phone.handset simgsm.phone.ui simgsm.thread
            simgsm.center.subscriber : simgsm.air simgsm.sim simgsm.ss
            simgsm.center.smsc       : simgsm.event simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.sms
            simgsm.center.journal    : simgsm.file simgsm.octets simgsm.air simgsm.sms simgsm.center.smsc simgsm.thread
            simgsm.center.smpp       : simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.sms simgsm.center.smsc simgsm.smpp
            simgsm.center.msc.link   : simgsm.octets simgsm.timer simgsm.air simgsm.abis simgsm.trace simgsm.center.subscriber
            simgsm.center.msc.mobility : simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.sim simgsm.center.subscriber simgsm.center.msc.link
            simgsm.center.msc.call   : simgsm.event simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.abis simgsm.ss simgsm.tone simgsm.dtmf simgsm.speech simgsm.center.subscriber simgsm.center.msc.link simgsm.center.msc.mobility
            simgsm.center.msc.sms    : simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.center.subscriber simgsm.center.smsc simgsm.center.msc.link
            simgsm.center.msc.ss     : simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.ss simgsm.center.subscriber simgsm.center.msc.link simgsm.lesson
            simgsm.center.bsc.handover : simgsm.octets
            simgsm.center.bsc        : simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.abis simgsm.rr simgsm.center.subscriber simgsm.center.msc.link simgsm.center.bsc.handover
            simgsm.center.msc        : simgsm.event simgsm.center.bsc simgsm.center.bsc.handover simgsm.octets simgsm.timer simgsm.air simgsm.air.answer simgsm.abis simgsm.sms simgsm.trace simgsm.tone simgsm.center.subscriber simgsm.center.smsc simgsm.center.msc.link simgsm.center.msc.mobility simgsm.center.msc.call simgsm.center.msc.sms simgsm.center.msc.ss simgsm.lesson
            simgsm.center.records    : simgsm.file simgsm.air simgsm.sms simgsm.center.smsc simgsm.center.msc.call simgsm.center.msc simgsm.thread
            simgsm.center.web        : simgsm.event simgsm.air simgsm.sms simgsm.web simgsm.center.subscriber simgsm.center.smsc simgsm.center.msc.call simgsm.center.msc
            simgsm.center.capture    : simgsm.file simgsm.octets simgsm.abis simgsm.thread
            simgsm.center.net        : simgsm.timer simgsm.net simgsm.abis simgsm.center.smpp simgsm.center.msc.link simgsm.center.msc simgsm.center.capture
            simgsm.center.ui.ladder  : simgsm.abis simgsm.air simgsm.center.msc simgsm.console simgsm.draw simgsm.file simgsm.octets simgsm.sms simgsm.trace simgsm.ui simgsm.ui.file simgsm.ui.glossary simgsm.ui.pane
            simgsm.center.ui         : simgsm.air simgsm.sms simgsm.console simgsm.draw simgsm.ui simgsm.ui.pane simgsm.ui.window simgsm.center.smsc simgsm.center.msc.call simgsm.center.msc simgsm.center.ui.ladder simgsm.thread
            simgsm.center.app        : simgsm.event simgsm.file simgsm.net simgsm.center.bsc.handover simgsm.octets simgsm.air simgsm.sim simgsm.tone simgsm.console simgsm.draw simgsm.ui simgsm.ui.window simgsm.center.subscriber simgsm.center.smsc simgsm.center.journal simgsm.center.smpp simgsm.center.msc.call simgsm.center.msc simgsm.center.capture simgsm.center.net simgsm.web simgsm.center.records simgsm.center.web simgsm.center.ui simgsm.lesson
            simgsm.center            :
            simgsm.classroom.ui      : simgsm.console simgsm.draw simgsm.file simgsm.lesson simgsm.ui simgsm.ui.file simgsm.ui.glossary simgsm.ui.pane simgsm.ui.window simgsm.web
            simgsm.classroom.session : simgsm.air simgsm.center.app simgsm.center.msc simgsm.console simgsm.lesson simgsm.ui.window simgsm.thread
            simgsm.classroom.demo    : simgsm.air simgsm.center.app simgsm.classroom.session simgsm.classroom.ui simgsm.console simgsm.file simgsm.lesson simgsm.net simgsm.ui.window simgsm.thread
            simgsm.classroom.lesson  : simgsm.air simgsm.center.app simgsm.center.msc simgsm.classroom.demo simgsm.classroom.session simgsm.classroom.ui simgsm.console simgsm.dtmf simgsm.file simgsm.lesson simgsm.octets simgsm.sms simgsm.ui simgsm.ui.window simgsm.thread
            simgsm.classroom         : simgsm.center simgsm.center.app simgsm.classroom.demo simgsm.classroom.lesson simgsm.console simgsm.ui.window
            simgsm.cells.town        : simgsm.octets simgsm.rr simgsm.file
            simgsm.cells.radio       : simgsm.cells.town
            simgsm.cells.snapshot    : simgsm.cells.town
            simgsm.cells.ui          : simgsm.console simgsm.draw simgsm.ui simgsm.ui.pane simgsm.ui.window simgsm.cells.town simgsm.cells.radio simgsm.cells.snapshot simgsm.thread
            simgsm.cells.cipher      : simgsm.octets simgsm.air simgsm.abis
            simgsm.cells.capture     : simgsm.octets simgsm.air simgsm.cells.cipher
            simgsm.cells.tower       : simgsm.event simgsm.octets simgsm.timer simgsm.air simgsm.abis simgsm.rr simgsm.cells.town simgsm.cells.cipher simgsm.cells.capture
            simgsm.cells.mobile      : simgsm.event simgsm.octets simgsm.state simgsm.timer simgsm.air simgsm.abis simgsm.rr simgsm.speech simgsm.cells.town simgsm.cells.radio simgsm.cells.snapshot simgsm.cells.cipher simgsm.cells.tower
            simgsm.cells.network     : simgsm.octets simgsm.timer simgsm.air simgsm.rr simgsm.cells.town simgsm.cells.radio simgsm.cells.snapshot simgsm.cells.tower simgsm.cells.mobile
            simgsm.cells.net         : simgsm.timer simgsm.net simgsm.air simgsm.abis simgsm.cells.town simgsm.cells.tower simgsm.cells.mobile simgsm.cells.network simgsm.thread
            simgsm.cells.app         : simgsm.event simgsm.file simgsm.octets simgsm.air simgsm.rr simgsm.console simgsm.ui.window simgsm.cells.ui simgsm.cells.town simgsm.cells.radio simgsm.cells.snapshot simgsm.cells.tower simgsm.cells.mobile simgsm.cells.network simgsm.cells.net
            simgsm.cells             : simgsm.console simgsm.ui.window simgsm.cells.town simgsm.cells.app simgsm.cells.tower simgsm.cells.net simgsm.cells.network
            simgsm.gateway.speech    : simgsm.speech simgsm.station.call
            simgsm.gateway.sip       : simgsm.state simgsm.timer simgsm.air simgsm.dtmf simgsm.speech simgsm.station.call simgsm.station.context simgsm.station.mobility simgsm.station simgsm.gateway.speech
            simgsm.gateway.esme      : simgsm.octets simgsm.timer simgsm.air simgsm.sms simgsm.smpp
            simgsm.gateway.mail      : simgsm.console simgsm.octets simgsm.timer simgsm.air simgsm.sms simgsm.smpp simgsm.gateway.esme
            simgsm.gateway.fax       :
            simgsm.gateway           : simgsm.event simgsm.file simgsm.net simgsm.timer simgsm.smpp simgsm.gateway.speech simgsm.gateway.sip simgsm.gateway.esme simgsm.gateway.mail simgsm.gateway.fax simgsm.air simgsm.trace simgsm.dtmf simgsm.speech simgsm.words simgsm.station.call simgsm.station.context simgsm.station.mobility simgsm.station simgsm.console simgsm.web simgsm.thread
            simrobot.behaviour       :
            simrobot.world           : simgsm.file
            simrobot.bitmap          : simgsm.file simgsm.octets simrobot.world
            simrobot.editor          : simrobot.world
            simrobot.process         : simrobot.behaviour simrobot.world
            simrobot.source.child    : simrobot.behaviour
            simrobot.source          : simgsm.file simrobot.behaviour simrobot.process simrobot.source.child simgsm.thread
            simrobot.route           : simrobot.behaviour simrobot.process simrobot.world
            simrobot.robot           : vericommand simrobot.behaviour simrobot.world simrobot.process
            simrobot.simulation      : vericommand simrobot.behaviour simrobot.process simrobot.route simrobot.world simrobot.robot simgsm.thread
            simrobot.camera          : vericommand simrobot.world simrobot.robot simrobot.simulation
            simrobot.p2os            : simgsm.octets simgsm.net simgsm.state vericommand simrobot.robot simrobot.simulation simgsm.thread
            simrobot.pioneer         : simgsm.net vericommand simrobot.behaviour simrobot.process simrobot.robot simrobot.simulation simrobot.p2os simgsm.thread
            simrobot.replay          : simgsm.octets vericommand simgsm.console simrobot.process simrobot.world simrobot.robot simrobot.simulation simgsm.thread
            simrobot.drawing         : vericommand simgsm.draw simrobot.behaviour simrobot.world simrobot.robot simrobot.simulation
            simrobot.http            : simgsm.timer simgsm.web vericommand simgsm.console simgsm.draw simrobot.process simrobot.world simrobot.robot simrobot.simulation simrobot.camera simrobot.drawing simgsm.thread
            simrobot.ros             : simgsm.net simgsm.web vericommand simrobot.robot simrobot.simulation simrobot.camera simgsm.thread
            simrobot.control         : simgsm.event simgsm.file simgsm.modem.at simgsm.modem.at.command simgsm.modem.at.port simgsm.net vericommand simgsm.air simgsm.sim simgsm.tone simgsm.dtmf simgsm.scope simgsm.speech simgsm.words simgsm.console simgsm.station simgsm.station.context simgsm.station.mobility simgsm.station.call simgsm.modem simgsm.modem.client simgsm.modem.line simrobot.behaviour simrobot.process simrobot.route simrobot.world simrobot.robot simrobot.simulation simrobot.camera simrobot.pioneer simgsm.thread
            simrobot.ui              : vericommand simgsm.tone simgsm.dtmf simgsm.scope simgsm.station simgsm.station.call simgsm.console simgsm.draw simgsm.ui simgsm.ui.file simrobot.process simrobot.world simrobot.robot simrobot.simulation simrobot.drawing simrobot.replay simrobot.control
            simrobot.ui.floor        : vericommand simgsm.console simgsm.draw simgsm.ui simrobot.world simrobot.editor simrobot.robot simrobot.simulation simrobot.drawing simrobot.control simrobot.ui
            simrobot.ui.editor       : simgsm.console simgsm.draw simgsm.ui simrobot.world simrobot.editor simrobot.robot simrobot.simulation simrobot.drawing simrobot.ui simrobot.ui.floor
            simrobot.ui.replay       : simrobot.drawing simgsm.console simgsm.draw simgsm.ui simrobot.replay simrobot.ui
            simrobot.ui.telephone    : vericommand simgsm.air simgsm.tone simgsm.dtmf simgsm.scope simgsm.station simgsm.station.call simgsm.console simgsm.draw simgsm.ui simgsm.ui.scope simrobot.ui
            simrobot.ui.inspector    : vericommand simgsm.modem simgsm.console simgsm.draw simgsm.ui simgsm.ui.pane simrobot.process simrobot.world simrobot.robot simrobot.simulation simrobot.drawing simrobot.camera simrobot.control simrobot.ui simrobot.ui.floor simgsm.thread
            simrobot.ui.panel        : vericommand simgsm.air simgsm.speech simgsm.station simgsm.station.call simgsm.console simgsm.draw simgsm.ui simgsm.ui.pane simgsm.ui.file simgsm.ui.window simgsm.ui.scope simrobot.process simrobot.world simrobot.robot simrobot.simulation simrobot.drawing simrobot.camera simrobot.control simrobot.ui simrobot.ui.floor simrobot.ui.editor simrobot.ui.replay simrobot.ui.telephone simrobot.ui.inspector
            simrobot.app             : simgsm.file simgsm.air simgsm.audio simgsm.console simgsm.modem simgsm.modem.client simgsm.net simgsm.sim simgsm.speech simgsm.station simgsm.words simrobot.bitmap simrobot.control simrobot.pioneer simrobot.process simrobot.replay simrobot.robot simrobot.simulation simrobot.source simrobot.world vericommand
            simrobot.app.ports       : simgsm.air simgsm.console simgsm.modem simgsm.modem.at simgsm.modem.at.port simgsm.modem.client simgsm.net simgsm.web vericommand simrobot.app simrobot.control simrobot.http simrobot.p2os simrobot.robot simrobot.ros simrobot.simulation simrobot.world simgsm.thread
            simrobot.app.window      : simgsm.air simgsm.console simgsm.speech simgsm.station simgsm.tone simgsm.ui.window simrobot.app simrobot.app.ports simrobot.control simrobot.process simrobot.replay simrobot.robot simrobot.simulation simrobot.ui simrobot.ui.floor simrobot.ui.inspector simrobot.world vericommand simgsm.thread
            simrobot.app.batch       : simgsm.console simgsm.draw simgsm.file simgsm.modem.client simgsm.modem.line simgsm.net simgsm.sim simrobot.app simrobot.behaviour simrobot.control simrobot.process simrobot.replay simrobot.robot simrobot.simulation simrobot.world vericommand
            simrobot                 : simgsm.net vericommand simgsm.air simgsm.sim simgsm.speech simgsm.audio simgsm.console simgsm.station simgsm.modem simgsm.ui.window simrobot.process simrobot.world simrobot.robot simrobot.simulation simrobot.pioneer simrobot.replay simrobot.control simrobot.ui simrobot.ui.floor simrobot.ui.inspector simrobot.ui.panel simrobot.app simrobot.app.batch simrobot.app.ports simrobot.app.window
            """);

    private static Map<String, Set<String>> rows(String table) {
        Map<String, Set<String>> rows = new LinkedHashMap<>();
        table.lines().map(line -> line.split("\\s*:\\s*", 2)).forEach(row -> {
            Set<String> used =
                    row[1].isBlank() ? Set.of() : Set.of(row[1].strip().split("\\s+"));
            rows.put(row[0].strip(), used);
        });
        return rows;
    }

    @Test
    void everyPackageHasARow() {
        assertEquals(new TreeSet<>(MainCode.packages()), new TreeSet<>(MAY_USE.keySet()));
    }

    @Test
    void aRowNamesOnlyPackagesOfRowsAboveItSoThereAreNoCircles() {
        List<String> above = new ArrayList<>();
        MAY_USE.forEach((name, used) -> {
            assertEquals(Set.of(), minus(used, above), name);
            above.add(name);
        });
    }

    @Test
    void packagesUseOnlyWhatTheirRowsName() {
        Map<String, Set<String>> further = MainCode.CLASSES.stream()
                .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
                .filter(LayeringTest::isForbidden)
                .collect(Collectors.groupingBy(
                        LayeringTest::arrow,
                        Collectors.mapping(Dependency::getDescription, Collectors.toCollection(TreeSet::new))));
        assertEquals(Map.of(), further);
    }

    private static boolean isForbidden(Dependency use) {
        String from = use.getOriginClass().getPackageName();
        String to = use.getTargetClass().getPackageName();
        return MainCode.isOurs(to)
                && !to.equals(from)
                && !MAY_USE.getOrDefault(from, Set.of()).contains(to);
    }

    private static String arrow(Dependency use) {
        return use.getOriginClass().getPackageName()
                + " -> "
                + use.getTargetClass().getPackageName();
    }

    @Test
    void theLibrariesDoNotKnowTheProgramsNorAProgramAnother() {
        for (String program : List.of(
                "simgsm.classroom",
                "simgsm.center",
                "simgsm.cells",
                "simgsm.gateway",
                "simgsm.phone",
                "simrobot",
                "simgsm.tools")) {
            MAY_USE.forEach((from, used) -> {
                // the classroom is above the centre
                boolean isAbove = program.equals("simgsm.center") && isIn("simgsm.classroom", from);
                if (!isIn(program, from) && !isAbove) {
                    assertEquals(
                            List.of(),
                            used.stream().filter(to -> isIn(program, to)).toList(),
                            from);
                }
            });
        }
    }

    private static boolean isIn(String program, String packageName) {
        return packageName.equals(program) || packageName.startsWith(program + ".");
    }

    /** Packages that read or write pictures by ImageIO. */
    private static final Set<String> PICTURES = Set.of("simrobot.bitmap", "simrobot.camera", "simgsm.gateway.fax");

    @Test
    void swingAndAwtAreOnlyInWindowPackagesAndMains() {
        noClasses()
                .that()
                .resideOutsideOfPackage("..ui..")
                .and()
                .haveSimpleNameNotEndingWith("Main")
                .should()
                .dependOnClassesThat(DescribedPredicate.describe(
                        "belong to Swing or AWT", (JavaClass used) -> belongsToSwingOrAwt(used)))
                .check(MainCode.CLASSES.that(DescribedPredicate.describe(
                        "read or write pictures", (JavaClass type) -> !PICTURES.contains(type.getPackageName()))));
    }

    @Test
    void picturesUseOnlyImagesOfAwt() {
        noClasses()
                .that()
                .resideInAnyPackage(PICTURES.toArray(String[]::new))
                .should()
                .dependOnClassesThat(DescribedPredicate.describe(
                        "belong to Swing or AWT, images aside",
                        (JavaClass used) -> belongsToSwingOrAwt(used)
                                && !used.getPackageName().equals("java.awt.image")))
                .check(MainCode.CLASSES);
    }

    private static boolean belongsToSwingOrAwt(JavaClass used) {
        return used.getPackageName().startsWith("javax.swing")
                || used.getPackageName().equals("java.awt")
                || used.getPackageName().startsWith("java.awt.");
    }

    @Test
    void modulesRequireOneAnotherAndTheJdkAlone() {
        Set<String> known = MainCode.descriptors().stream()
                .map(ModuleDescriptor::name)
                .collect(Collectors.toCollection(TreeSet::new));
        ModuleFinder.ofSystem()
                .findAll()
                .forEach(module -> known.add(module.descriptor().name()));
        MainCode.descriptors()
                .forEach(module -> assertEquals(
                        Set.of(),
                        minus(module.requires().stream().map(Requires::name).collect(Collectors.toSet()), known),
                        module.name()));
    }

    @Test
    void javaDesktopIsRequiredOnlyForWindowsSoundFilesAndPictures() {
        assertEquals(Set.of("simgsm.desktop", "simgsm.tools", "simgsm.gateway"), modulesThatRequire("java.desktop"));
    }

    @Test
    void desktopIsRequiredOnlyByModulesWithWindows() {
        Set<String> withWindows = MainCode.descriptors().stream()
                .filter(module -> module.packages().stream().anyMatch(name -> name.matches(".*\\.ui(\\..*)?")))
                .map(ModuleDescriptor::name)
                .collect(Collectors.toSet());
        assertEquals(Set.of(), minus(modulesThatRequire("simgsm.desktop"), withWindows));
    }

    private static Set<String> modulesThatRequire(String required) {
        return MainCode.descriptors().stream()
                .filter(module ->
                        module.requires().stream().anyMatch(use -> use.name().equals(required)))
                .map(ModuleDescriptor::name)
                .collect(Collectors.toSet());
    }

    private static Set<String> minus(Set<String> these, Collection<String> those) {
        Set<String> left = new TreeSet<>(these);
        left.removeAll(those);
        return left;
    }

    private static final String[] CORES = {
        "vericommand",
        "simgsm.state",
        "simgsm.timer",
        "simgsm.air",
        "simgsm.abis",
        "simgsm.smpp",
        "simgsm.sms",
        "simgsm.ss",
        "simgsm.tone",
        "simgsm.dtmf",
        "simgsm.station..",
        "simgsm.modem",
        "simgsm.modem.at",
        "simgsm.modem.at.state",
        "simgsm.modem.at.sms",
        "simgsm.modem.at.command",
        "simgsm.modem.client",
        "simgsm.center.bsc..",
        "simgsm.center.msc..",
        "simgsm.center.smpp..",
        "simgsm.center.smsc",
        "simgsm.center.subscriber",
        "simgsm.phone.store",
        "simgsm.phone.screen",
        "simgsm.phone.handset",
        "simgsm.lesson",
        "simgsm.gateway.esme",
        "simgsm.gateway.mail",
        "simgsm.gateway.sip",
        "simgsm.gateway.speech",
        "simrobot.behaviour",
        "simrobot.robot",
        "simrobot.simulation"
    };

    /** Give the cores of their packages time and sockets. */
    private static final Set<String> SHELLS = Set.of(
            "StationThread",
            "StationLink",
            "IpaConnection",
            "MediaSocket",
            "SimulationThread",
            "PacedThread",
            "LessonLibrary");

    private static GivenClassesConjunction coreClasses() {
        return noClasses()
                .that()
                .resideInAnyPackage(CORES)
                .and()
                .haveSimpleNameNotEndingWith("Main")
                .and(DescribedPredicate.describe(
                        "are no shells",
                        (JavaClass each) -> !SHELLS.contains(outermost(each).getSimpleName())));
    }

    private static JavaClass outermost(JavaClass type) {
        return type.getEnclosingClass().map(LayeringTest::outermost).orElse(type);
    }

    @Test
    void coresKnowNoClockNoThreadNoSocketNoFile() {
        coreClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.net..", "java.nio.channels..", "java.nio.file..", "java.io")
                .check(MainCode.CLASSES);
        coreClasses()
                .should()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .orShould()
                .callMethod(Instant.class, "now")
                .check(MainCode.CLASSES);
        coreClasses()
                .should()
                .dependOnClassesThat()
                .areAssignableTo(Thread.class)
                .check(MainCode.CLASSES);
    }
}

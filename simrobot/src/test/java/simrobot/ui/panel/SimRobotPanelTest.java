package simrobot.ui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.RejectCause;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.sim.PinLock;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.ui.ComponentNames;
import simgsm.ui.Keycaps;
import simgsm.ui.Lamp;
import simgsm.ui.NumberedLabel;
import simgsm.ui.Theme;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.telephone.VeriCommandPanel;
import vericommand.Instruction;
import vericommand.OrderCourse;
import vericommand.OrderSource;
import vericommand.RobotStatus;
import vericommand.VeriCommandSnapshot;

class SimRobotPanelTest {
    private static final Locale ENGLISH = Locale.ENGLISH;

    @BeforeAll
    static void look() {
        Theme.install(Appearance.LIGHT);
    }

    @AfterEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    private static WindowBench bench() throws Exception {
        return new WindowBench("empty.map", ENGLISH, "robot");
    }

    private static WindowBench bench(TelephoneSnapshot line) throws Exception {
        WindowBench bench = bench();
        bench.lines = List.of(line);
        return bench.show().resize(1100, 800);
    }

    // ---- inspector
    // ---------------------------------------------------------------------------------------------------

    @Test
    void thePoseIsReadInMetresAndDegrees() throws Exception {
        WindowBench bench = bench();
        bench.simulation.robots().get(0).place(1.25, -0.5, Math.toRadians(-90));
        bench.show();
        assertEquals("x: 1.250 m", bench.spoken("pose.x"));
        assertEquals("y: -0.500 m", bench.spoken("pose.y"));
        assertEquals("heading: 270.0 \u00b0", bench.spoken("pose.heading"));
        assertEquals(
                "World empty.map, robot robot at 1.250 -0.500 metres, heading 270.0 degrees", bench.spoken("world"));
    }

    @Test
    void speedsAreReadWhileTheRobotMoves() throws Exception {
        WindowBench bench = bench();
        bench.simulation.robots().get(0).start(new Instruction.Forward(500), ended -> {});
        bench.simulation.run(300);
        bench.show();
        assertEquals("speed: 0.50 m/s", bench.spoken("pose.speed"));
    }

    @Test
    void odometryIsReadAgainstTheTruthAndTheBatteryInVolts() throws Exception {
        WindowBench bench = bench();
        var robot = bench.simulation.robots().get(0);
        robot.start(new Instruction.Forward(100), ended -> {});
        bench.simulation.run(600);
        bench.show();
        assertEquals("x: 1.000 m", bench.spoken("odometry.x"));
        assertEquals("position error: 0.000 m", bench.spoken("odometry.error"));
        assertTrue(bench.spoken("pose.battery").matches("battery: 1[23]\\.[0-9] V"), bench.spoken("pose.battery"));
        robot.place(robot.xMeters(), robot.yMeters() + 0.5, robot.headingRadians() + Math.toRadians(30));
        bench.show();
        assertEquals("position error: 0.500 m", bench.spoken("odometry.error"));
        assertEquals("heading error: -30.0 \u00b0", bench.spoken("odometry.turned"));
        robot.resetOdometry();
        bench.show();
        assertEquals("position error: 0.000 m", bench.spoken("odometry.error"));
        assertEquals("x: 0.000 m", bench.spoken("odometry.x"));
    }

    @Test
    void exactlyTheLampOfThePresentStatusIsLit() throws Exception {
        WindowBench bench = bench();
        assertLit(bench, RobotStatus.STOPPED);
        bench.simulation.robots().get(0).setMotors(false);
        assertLit(bench, RobotStatus.NO_MOTORS);
        bench.simulation.robots().get(0).setPower(false);
        assertLit(bench, RobotStatus.DISCONNECTED);
    }

    private static void assertLit(WindowBench bench, RobotStatus lit) {
        bench.show();
        for (RobotStatus status : RobotStatus.values()) {
            Lamp lamp = (Lamp) bench.component("status." + status.name().toLowerCase(Locale.ROOT));
            assertEquals(status == lit, lamp.isLit(), status + " while " + lit);
            assertFalse(lamp.word().isEmpty());
        }
    }

    @Test
    void theSonarTellsTheNearestEcho() throws Exception {
        WindowBench bench = bench();
        assertEquals("free for 5 m all around", bench.spoken("sonar"));
        bench.simulation.robots().get(0).place(0, 9, 0);
        bench.show();
        assertEquals("nearest: sonar 0, 0.86 m", bench.spoken("sonar"));
    }

    @Test
    void pickingAnotherRobotMakesTheWindowTellAboutIt() throws Exception {
        WindowBench bench = new WindowBench("office.map", ENGLISH, "anna", "bert");
        assertEquals("watch anna", bench.acts.get(0));
        ((JList<?>) bench.component("robots")).setSelectedIndex(1);
        assertTrue(bench.acts.contains("watch bert"));
        assertEquals("x: 2.050 m", bench.spoken("pose.x"));
    }

    // ---- tools
    // -------------------------------------------------------------------------------------------------------

    @Test
    void thePowerSwitchAsksForTheOppositeAndShowsWhatIs() throws Exception {
        WindowBench bench = bench();
        AbstractButton power = (AbstractButton) bench.component("tool.power");
        assertTrue(power.isSelected());
        bench.click("tool.power");
        assertTrue(bench.acts.contains("power robot false"));
        bench.show();
        assertFalse(power.isSelected());
        assertFalse(bench.component("tool.motors").isEnabled());
        bench.click("tool.power");
        bench.show();
        assertTrue(power.isSelected());
    }

    @Test
    void theMotorsSwitchWorksWhileThereIsPower() throws Exception {
        WindowBench bench = bench();
        bench.click("tool.motors");
        bench.show();
        assertFalse(((AbstractButton) bench.component("tool.motors")).isSelected());
        bench.click("tool.motors");
        assertEquals("motors robot true", bench.acts.get(bench.acts.size() - 1));
    }

    @Test
    void aSingleStepIsThereOnlyWhilePaused() throws Exception {
        WindowBench bench = bench();
        assertFalse(bench.component("tool.step").isEnabled());
        bench.click("tool.pause");
        bench.show();
        assertTrue(bench.component("tool.step").isEnabled());
        assertEquals("Resume", bench.spoken("tool.pause"));
        bench.click("tool.step");
        assertEquals(10_000_000, bench.simulation.timeNanos());
        bench.click("tool.pause");
        assertEquals("pause false", bench.acts.get(bench.acts.size() - 1));
    }

    @Test
    void aPaceIsChosenFromTheList() throws Exception {
        WindowBench bench = bench();
        JComboBox<?> speed = (JComboBox<?>) bench.component("tool.speed");
        speed.setSelectedIndex(speed.getItemCount() - 1);
        assertEquals("speed Infinity", bench.acts.get(bench.acts.size() - 1));
        assertEquals("\u00d7 max", speed.getSelectedItem());
    }

    @Test
    void zoomFitFollowAndLayersActOnTheFloor() throws Exception {
        WindowBench bench = bench();
        double fitted = bench.floor().viewport().pixelsPerMeter();
        bench.click("tool.zoom.in");
        assertEquals(1.25 * fitted, bench.floor().viewport().pixelsPerMeter(), 1e-9);
        bench.click("tool.fit");
        assertEquals(fitted, bench.floor().viewport().pixelsPerMeter(), 1e-9);
        assertFalse(bench.command("tool.rays"));
        assertFalse(bench.floor().layers().sonar());
        bench.simulation.robots().get(0).place(3, 2, 0);
        bench.command("tool.follow");
        assertTrue(bench.floor().isFollowing());
        bench.show();
        assertEquals(3, bench.floor().viewport().centerX());
    }

    @Test
    void theWorldsBesideThisOneAreOffered() throws Exception {
        WindowBench bench = bench();
        assertEquals("World: empty.map", bench.spoken("tool.world"));
    }

    @Test
    void anotherWorldIsFittedIntoTheView() throws Exception {
        WindowBench bench = bench();
        bench.floor().zoom(3);
        bench.simulation.load(WindowBench.world("corridor.map"));
        bench.show();
        assertTrue(bench.floor().viewport().shows(-1, 0, 0));
        assertTrue(bench.floor().viewport().shows(23, 0, 0));
    }

    @Test
    void aNoticeIsShownAndGoesAway() throws Exception {
        WindowBench bench = bench();
        bench.notice = "nowhere.map: no such file";
        bench.show();
        assertEquals("nowhere.map: no such file", bench.spoken("notice"));
        assertTrue(bench.component("notice").getParent().isVisible());
        bench.notice = "";
        bench.show();
        assertFalse(bench.component("notice").getParent().isVisible());
    }

    @Test
    void aWorldThatWasChangedOnTheDiskIsSaidUntilItIsLoadedAgain() throws Exception {
        WindowBench bench = bench();
        bench.worldChanged = true;
        bench.show();
        assertEquals(
                "empty.map has been changed on the disk. Ctrl+O, \"Load again\" loads it.", bench.spoken("notice"));
        bench.worldChanged = false;
        bench.show();
        assertFalse(bench.component("notice").getParent().isVisible());
    }

    // ---- modem and VeriCommand
    // -----------------------------------------------------------------------------------------

    @Test
    void theModemShowsNumberNetworkAndCall() throws Exception {
        WindowBench bench = bench(WindowBench.line("robot", true, true, WindowBench.noOrders(), ""));
        assertEquals("5550200", bench.spoken("modem.number"));
        assertEquals("SimGSM", bench.spoken("modem.network"));
        assertEquals("Call: in call with", bench.spoken("modem.call"));
        assertEquals("5550100", bench.spoken("modem.peer"));
        assertTrue(bench.spoken("lamp.link").endsWith("in service"), bench.spoken("lamp.link"));
    }

    @ParameterizedTest
    @CsvSource({
        "3, true, SIM not accepted",
        "3, false, number in use",
        "2, false, SIM unknown here",
        "6, false, modem barred",
        "11, false, SIM barred",
        "22, false, congestion"
    })
    void aModemThatTheNetworkRefusesSaysWhy(int cause, boolean cardRefused, String words) throws Exception {
        TelephoneSnapshot line = WindowBench.line("robot", false, false, WindowBench.noOrders(), "");
        StationSnapshot refused = new StationSnapshot(
                true,
                true,
                false,
                Optional.of(RejectCause.ofCode(cause, simgsm.air.Direction.DOWNLINK)),
                cardRefused,
                "",
                MobileCallState.NULL,
                Optional.empty(),
                Optional.of(SpeechCodec.Kind.A_LAW),
                Optional.empty(),
                Optional.empty(),
                PinLock.none().status());
        WindowBench bench = bench(new TelephoneSnapshot(
                line.robot(), line.number(), refused, line.heard(), line.orders(), line.tones(), "", line.audible()));
        assertEquals(words, bench.spoken("modem.network"));
        assertTrue(bench.spoken("lamp.link").endsWith("refused"), bench.spoken("lamp.link"));
        // the demo's size has no room for the line of the network
        bench.resize(1024, 416).resize(1024, 416).show();
        assertEquals(Optional.empty(), ComponentNames.find(bench.panel, "modem.network"));
        assertEquals("Call: " + words, bench.spoken("modem.call"));
    }

    @Test
    void aRingingModemNamesTheCaller() throws Exception {
        TelephoneSnapshot line = WindowBench.line("robot", true, true, WindowBench.noOrders(), "");
        StationSnapshot ringing = new StationSnapshot(
                true,
                true,
                true,
                Optional.empty(),
                false,
                "SimGSM",
                MobileCallState.CALL_RECEIVED,
                line.modem().peer(),
                Optional.of(SpeechCodec.Kind.A_LAW),
                Optional.empty(),
                Optional.empty(),
                PinLock.none().status());
        WindowBench bench = bench(new TelephoneSnapshot(
                line.robot(), line.number(), ringing, line.heard(), line.orders(), line.tones(), "", line.audible()));
        assertEquals("Call: ringing, call from", bench.spoken("modem.call"));
        assertTrue(bench.spoken("modem.peer").endsWith("5550100"), bench.spoken("modem.peer"));
    }

    @Test
    void theModemShowsHowSpeechIsCodedEachWay() throws Exception {
        WindowBench bench = bench(WindowBench.line("robot", true, false, WindowBench.noOrders(), ""));
        assertEquals("A-law", bench.spoken("modem.codec"));
        WindowBench mixed = bench(WindowBench.line(
                "robot", true, true, WindowBench.noOrders(), "", Optional.of(SpeechCodec.Kind.GSM_FULL_RATE)));
        assertEquals("A-law out, GSM 06.10 in", mixed.spoken("modem.codec"));
    }

    @Test
    void theModemsFactsReturnToTheirPlacesAfterALowWindow() throws Exception {
        WindowBench bench = bench(WindowBench.line("robot", true, false, WindowBench.noOrders(), ""));
        Rectangle before = bench.component("modem.codec").getBounds();
        bench.resize(764, 432).show().resize(1100, 800);
        assertEquals(before, bench.component("modem.codec").getBounds());
    }

    @Test
    void keysThatFitTakeOneRowAfterANarrowLayout() {
        VeriCommandPanel panel = new VeriCommandPanel(SimRobotTexts.in(ENGLISH), ENGLISH);
        panel.show(WindowBench.line(
                "robot", true, true, WindowBench.orders("**#**20**", "forward 20 cm", "accepted", "accepted", 0), "1"));
        Component keys = ComponentNames.find(panel, "order.keys").orElseThrow();
        for (int width : new int[] {100, 400}) {
            panel.setSize(width, 400);
            WindowBench.layout(panel);
        }
        assertEquals(keys.getMinimumSize().height, keys.getHeight());
    }

    @Test
    void theModemSaysQuietlyThatThereIsNoSound() throws Exception {
        TelephoneSnapshot mute = WindowBench.line("robot", true, false, WindowBench.noOrders(), "");
        assertEquals("no sound", ((JLabel) bench(mute).component("modem.sound")).getText());
        TelephoneSnapshot audible = new TelephoneSnapshot(
                mute.robot(), mute.number(), mute.modem(), mute.heard(), mute.orders(), mute.tones(), "", true);
        JLabel sound = (JLabel) bench(audible).component("modem.sound");
        assertEquals("", sound.getText());
        assertEquals("Calls are played", sound.getToolTipText());
    }

    @Test
    void theWordsThatTheModemSaysReplaceTheReplysText() throws Exception {
        TelephoneSnapshot mute = WindowBench.line("robot", true, true, WindowBench.noOrders(), "8");
        TelephoneSnapshot speaking = new TelephoneSnapshot(
                mute.robot(),
                mute.number(),
                mute.modem(),
                mute.heard(),
                mute.orders(),
                mute.tones(),
                "Not possible no motors",
                false);
        assertEquals("says: Not possible no motors", bench(speaking).spoken("order.reply"));
    }

    @Test
    void theLinkLampSearchesWithoutACentre() throws Exception {
        WindowBench bench = bench(WindowBench.line("robot", false, false, WindowBench.noOrders(), ""));
        assertTrue(bench.spoken("lamp.link").endsWith("searching"), bench.spoken("lamp.link"));
        assertEquals("no network", bench.spoken("modem.network"));
        assertEquals("Call: no call", bench.spoken("modem.call"));
        assertEquals("No order yet", bench.spoken("order.from"));
        assertEquals("Verdict: waiting for keys", bench.spoken("order.verdict"));
    }

    @Test
    void keysWordsAndVerdictOfAnOrderAreShown() throws Exception {
        VeriCommandSnapshot order = WindowBench.orders("**#**20**", "forward 20 cm", "accepted", "accepted", 0);
        WindowBench bench = bench(WindowBench.line("robot", true, true, order, "163"));
        assertEquals("Keys of the order: **#**20**", bench.spoken("order.keys"));
        assertEquals("forward 20 cm", bench.spoken("order.words"));
        assertEquals("Verdict: accepted", bench.spoken("order.verdict"));
        assertEquals("Call from 5550100", bench.spoken("order.from"));
        assertEquals("6 executing", bench.spoken("reply.6"));
        assertEquals(NumberedLabel.class, bench.component("reply.3").getClass());
    }

    @Test
    void keysAreReadInACallOnly() throws Exception {
        VeriCommandSnapshot inCall = WindowBench.orders("*", "", "", "", 0);
        WindowBench bench = bench(WindowBench.line("robot", true, true, inCall, "1"));
        assertEquals("Verdict: reading", bench.spoken("order.verdict"));
        VeriCommandSnapshot ended = new VeriCommandSnapshot(
                "5550100",
                OrderSource.CALL,
                false,
                false,
                "*",
                inCall.words(),
                "",
                inCall.verdictText(),
                OrderCourse.NONE,
                0,
                List.of());
        bench = bench(WindowBench.line("robot", true, false, ended, "1"));
        assertEquals("Verdict: waiting for keys", bench.spoken("order.verdict"));
    }

    @Test
    void aFaultIsMarkedAtItsPositionWithWhatWasExpected() throws Exception {
        VeriCommandSnapshot order = WindowBench.orders(
                "**#*A", "", "invalid", "Not a valid command: * or # or digit expected at key 5.", 5);
        WindowBench bench = bench(WindowBench.line("robot", true, true, order, "17"));
        assertEquals(5, ((Keycaps) bench.component("order.keys")).faultPosition());
        assertEquals("Verdict: Not a valid command: * or # or digit expected at key 5.", bench.spoken("order.verdict"));
    }

    @Test
    void theRepliesToAMessageAreShownAsChipsAndInFull() throws Exception {
        VeriCommandSnapshot order = new VeriCommandSnapshot(
                "5550100",
                OrderSource.MESSAGE,
                false,
                false,
                "**#**20**",
                WindowBench.said("forward 20 cm"),
                "accepted",
                WindowBench.said("accepted"),
                OrderCourse.EXECUTED,
                0,
                List.of("3 Done: #**20."));
        WindowBench bench = bench(WindowBench.line("robot", true, false, order, ""));
        assertEquals("Message from 5550100", bench.spoken("order.from"));
        assertEquals("Verdict: accepted", bench.spoken("order.verdict"));
        assertEquals("Outcome: executed", bench.spoken("order.course"));
        assertEquals("3 Done: #**20.", bench.spoken("order.reply"));
        assertEquals("3 executed", bench.spoken("reply.3"));
    }

    @Test
    void aRobotWithoutAModemHasNoTelephonePanels() throws Exception {
        WindowBench bench = bench();
        assertFalse(bench.component("modem.number").getParent().isShowing());
        assertFalse(bench.component("lamp.link").isVisible());
    }

    // ---- looks
    // ---------------------------------------------------------------------------------------------------------

    @Test
    void spanishIsSpanish() throws Exception {
        WindowBench bench = new WindowBench("empty.map", Locale.forLanguageTag("es"), "robot");
        assertEquals("libre 5 m alrededor", bench.spoken("sonar"));
        assertEquals("Parado", ((Lamp) bench.component("status.stopped")).word());
    }

    @ParameterizedTest
    @EnumSource(Appearance.class)
    void theWholeWindowPaintsAtEveryScaleSmallAndLarge(Appearance appearance) throws Exception {
        Theme.install(appearance);
        WindowBench bench = new WindowBench("demo.map", ENGLISH, "robot");
        bench.lines = List.of(WindowBench.line("robot", true, true, WindowBench.noOrders(), "1"));
        bench.show();
        for (double scale : new double[] {1, 1.25, 2}) {
            int width = scale == 1.25 ? 1200 : 640;
            bench.resize(width, width * 3 / 4);
            var image = WindowBench.painted(bench.panel, scale);
            assertTrue(WindowBench.count(image, Ink.ROBOT) > 3, width + " at " + scale);
            assertTrue(WindowBench.count(image, Ink.WALL) > 30, width + " at " + scale);
            assertTrue(WindowBench.count(image, Ink.CARD) > 10_000, width + " at " + scale);
        }
    }

    @Test
    void everyControlHasANameForTestsAndOneForScreenReaders() throws Exception {
        WindowBench bench = bench(WindowBench.line("robot", true, false, WindowBench.noOrders(), ""));
        for (String tool :
                List.of("power", "motors", "brake", "pause", "step", "speed", "zoom.in", "zoom.out", "fit", "world")) {
            assertFalse(bench.spoken("tool." + tool).isBlank(), tool);
            assertTrue(bench.component("tool." + tool).isFocusable(), tool);
        }
    }
}

package simrobot.ui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.modem.ModemState;
import simgsm.ui.Theme;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEvent;
import simrobot.drawing.RobotPreview;
import simrobot.drawing.Viewport;
import simrobot.process.BehaviourKind;
import simrobot.robot.SimulatedRobot;
import simrobot.ui.OpenPort;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.inspector.EventTexts;
import simrobot.ui.inspector.EventsCard;
import vericommand.Pose;
import vericommand.RobotStatus;

/** Robots come, go, and are put somewhere by hand; the called robot is shown. */
class RobotsInTheWindowTest {
    private WindowBench bench;

    @BeforeEach
    void twoRobotsInAnOffice() throws Exception {
        Theme.install(Appearance.LIGHT);
        bench = new WindowBench("office.map", Locale.ENGLISH, "anna", "bert");
    }

    // ---- add and remove
    // ---------------------------------------------------------------------------------------------

    @Test
    void theFormOffersANameAndANumberThatAreFree() {
        bench.lines = List.of(WindowBench.line("anna", true, false, WindowBench.noOrders(), ""));
        bench.show().click("robot.add");
        assertEquals("robot3", ((JTextField) bench.component("newcomer.name")).getText());
        assertEquals("5550201", ((JTextField) bench.component("newcomer.number")).getText());
    }

    @Test
    void aRobotIsAddedAndSelected() throws Exception {
        bench.click("robot.add");
        bench.type("newcomer.name", "carl");
        bench.type("newcomer.number", "5550300");
        bench.type("newcomer.x", "4,5");
        bench.type("newcomer.y", "6");
        bench.click("newcomer.add");
        bench.settle();
        assertTrue(bench.acts.contains("add carl 5550300 at 4.50 6.00"), bench.acts.toString());
        assertFalse(bench.component("newcomer.name").getParent().isShowing());
        assertTrue(bench.spoken("world").contains("robot carl at"), bench.spoken("world"));
    }

    @Test
    void whyARobotIsNotAddedIsSaidInTheForm() throws Exception {
        bench.click("robot.add");
        bench.refusal = Optional.of("another robot has the number 5550200");
        bench.click("newcomer.add");
        bench.settle();
        assertEquals("another robot has the number 5550200", bench.spoken("newcomer.problem"));
        bench.type("newcomer.x", "far");
        bench.click("newcomer.add");
        assertEquals("expected a number, found far", bench.spoken("newcomer.problem"));
    }

    @Test
    void whyARobotIsNotAddedIsInViewInAWindowThatShowsOnlyPartOfTheForm() throws Exception {
        bench.resize(1024, 416).resize(1024, 416);
        bench.click("tool.inspector");
        bench.resize(1024, 416).click("robot.add");
        bench.resize(1024, 416).resize(1024, 416);
        JComponent problem = (JComponent) bench.component("newcomer.problem");
        assertTrue(problem.getVisibleRect().height < problem.getHeight());
        bench.refusal = Optional.of("another robot has the number 5550200");
        bench.click("newcomer.add");
        bench.settle();
        assertEquals(problem.getHeight(), problem.getVisibleRect().height);
        JComponent button = (JComponent) bench.component("newcomer.add");
        assertEquals(button.getHeight(), button.getVisibleRect().height);
    }

    @Test
    void aClickOnTheFloorNamesThePlaceAndADragTheHeading() {
        bench.click("robot.add");
        Viewport view = bench.floor().viewport();
        int x = (int) Math.round(view.screenX(6.5));
        int y = (int) Math.round(view.screenY(6));
        mouse(MouseEvent.MOUSE_PRESSED, x, y, 0);
        assertEquals("6.50", ((JTextField) bench.component("newcomer.x")).getText());
        mouse(MouseEvent.MOUSE_DRAGGED, x, y - 40, InputEvent.SHIFT_DOWN_MASK);
        assertEquals("90", ((JTextField) bench.component("newcomer.heading")).getText());
        assertTrue(bench.floor().placing().preview().isPresent());
        bench.click("newcomer.cancel");
        assertTrue(bench.floor().placing().preview().isEmpty());
    }

    @Test
    void theSelectedRobotIsRemovedAndAnotherOneIsShown() {
        bench.click("robot.remove");
        bench.show();
        assertTrue(bench.acts.contains("remove anna"));
        assertTrue(bench.spoken("world").contains("robot bert"), bench.spoken("world"));
        bench.click("robot.remove");
        bench.show();
        assertEquals("World office.map, no robot", bench.spoken("world"));
        assertFalse(bench.component("robot.remove").isEnabled());
    }

    @Test
    void aRemovedRobotIsPutBackWhereItStood() throws Exception {
        bench.lines = List.of(WindowBench.line("anna", true, false, WindowBench.noOrders(), ""));
        SimulatedRobot anna = bench.simulation.robot("anna").orElseThrow();
        anna.place(4.5, 6, 0);
        bench.show();
        assertFalse(bench.component("robot.restore").isVisible());
        bench.click("robot.remove");
        bench.lines = List.of();
        bench.show();
        assertTrue(bench.component("robot.restore").isVisible());
        assertEquals("Put back anna", ((AbstractButton) bench.component("robot.restore")).getText());
        bench.click("robot.restore");
        bench.show();
        assertTrue(bench.acts.contains("add anna 5550200 at 4.50 6.00"), bench.acts.toString());
        assertFalse(bench.component("robot.restore").isVisible(), "it is there again");
        bench.click("robot.remove");
        bench.show();
        assertEquals("Put back bert", ((AbstractButton) bench.component("robot.restore")).getText());
    }

    @Test
    void ofTwoRemovedRobotsTheLastIsPutBack() throws Exception {
        bench = new WindowBench("office.map", Locale.ENGLISH, "anna", "bert", "carl");
        bench.show().click("robot.remove");
        bench.show().click("robot.remove");
        bench.show();
        assertEquals("Put back bert", ((AbstractButton) bench.component("robot.restore")).getText());
        bench.click("robot.restore");
        assertTrue(bench.acts.stream().anyMatch(act -> act.startsWith("add bert ")), bench.acts.toString());
    }

    @Test
    void ctrlAndAnArrowGoFromRobotToRobot() {
        act("robots.step.1");
        assertTrue(bench.spoken("world").contains("robot bert"));
        act("robots.step.1");
        assertTrue(bench.spoken("world").contains("robot anna"));
        act("robots.step.-1");
        assertTrue(bench.spoken("world").contains("robot bert"));
    }

    private void act(String id) {
        for (var c = bench.component("robots"); c != null; c = c.getParent()) {
            if (c instanceof javax.swing.JComponent owner
                    && owner.getActionMap().get(id) != null) {
                owner.getActionMap().get(id).actionPerformed(null);
                return;
            }
        }
        throw new AssertionError("no act " + id);
    }

    // ---- by hand
    // ----------------------------------------------------------------------------------------------------

    @Test
    void aRobotThatIsDraggedIntoAWallShowsWhyNotAndSnapsBack() throws Exception {
        var robot = bench.simulation.robots().get(0);
        robot.place(9, 6, 0);
        bench.show();
        press(9, 6);
        drag(9.5, 6);
        bench.settle();
        assertEquals(9.5, robot.xMeters(), 0.05);
        drag(9.5, 7);
        bench.settle();
        RobotPreview ghost = bench.floor().placing().preview().orElseThrow();
        assertTrue(ghost.refused());
        assertEquals("the place is occupied", ghost.text());
        release();
        bench.settle();
        assertEquals(9, robot.xMeters());
        assertEquals(6, robot.yMeters());
        assertTrue(bench.floor().placing().preview().isPresent());
    }

    @Test
    void aRobotThatFitsStaysWhereItIsLetGo() throws Exception {
        var robot = bench.simulation.robots().get(0);
        robot.place(9, 6, 0);
        bench.show();
        press(9, 6);
        drag(10, 6.25);
        release();
        bench.settle();
        assertEquals(10, robot.xMeters(), 0.05);
        assertTrue(bench.floor().placing().preview().isEmpty());
    }

    @Test
    void draggedWithShiftARobotTurnsInStepsOf15Degrees() throws Exception {
        var robot = bench.simulation.robots().get(0);
        robot.place(9, 6, 0);
        bench.show();
        mouse(MouseEvent.MOUSE_PRESSED, screenX(9), screenY(6), InputEvent.SHIFT_DOWN_MASK);
        mouse(MouseEvent.MOUSE_DRAGGED, screenX(9.2), screenY(7), InputEvent.SHIFT_DOWN_MASK);
        bench.settle();
        assertEquals(Math.toRadians(75), robot.headingRadians(), 1e-9);
        assertEquals(9, robot.xMeters());
    }

    private void press(double x, double y) {
        mouse(MouseEvent.MOUSE_PRESSED, screenX(x), screenY(y), 0);
    }

    private void drag(double x, double y) {
        mouse(MouseEvent.MOUSE_DRAGGED, screenX(x), screenY(y), 0);
    }

    private void release() {
        mouse(MouseEvent.MOUSE_RELEASED, 0, 0, 0);
    }

    private int screenX(double x) {
        return (int) Math.round(bench.floor().viewport().screenX(x));
    }

    private int screenY(double y) {
        return (int) Math.round(bench.floor().viewport().screenY(y));
    }

    private void mouse(int id, int x, int y, int modifiers) {
        int left = modifiers | InputEvent.BUTTON1_DOWN_MASK;
        bench.floor().dispatchEvent(new MouseEvent(bench.floor(), id, 0, left, x, y, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void aProcessIsChosenAndShownAsLongAsItRuns() {
        JComboBox<?> process = (JComboBox<?>) bench.component("robot.behaviour");
        process.setSelectedIndex(1);
        assertTrue(bench.acts.contains("behaviour anna wander"));
        bench.show();
        assertEquals("wander", process.getSelectedItem());
        bench.simulation.robots().get(0).brakeAtOnce();
        bench.show();
        assertEquals("none", process.getSelectedItem());
    }

    // ---- the called robot
    // ---------------------------------------------------------------------------------------------

    @Test
    void theWindowGoesOverToARobotThatIsCalledWhileTheSelectedOneIsNot() {
        call(false, true);
        assertTrue(bench.spoken("world").contains("robot bert"));
        assertFalse(bench.component("elsewhere").getParent().isVisible()
                && !bench.spoken("elsewhere").isEmpty());
    }

    @Test
    void whileTheSelectedRobotIsInACallTheOtherOneIsNamedAndOffered() {
        call(true, false);
        assertTrue(bench.spoken("world").contains("robot anna"));
        call(true, true);
        assertTrue(bench.spoken("world").contains("robot anna"));
        assertEquals("bert is in a call with 5550100.", bench.spoken("elsewhere"));
        bench.click("elsewhere.show");
        assertTrue(bench.spoken("world").contains("robot bert"));
        assertEquals("anna is in a call with 5550100.", bench.spoken("elsewhere"));
    }

    private void call(boolean anna, boolean bert) {
        bench.lines = List.of(
                WindowBench.line("anna", true, anna, WindowBench.noOrders(), ""),
                WindowBench.line("bert", true, bert, WindowBench.noOrders(), ""));
        bench.show();
    }

    // ---- ports and events
    // ------------------------------------------------------------------------------------------

    @Test
    void thePortsOfTheSelectedRobotAndOfTheProgramAreShown() {
        bench.ports = List.of(
                new OpenPort("P2OS", "anna", 8101), new OpenPort("P2OS", "bert", 8102), new OpenPort("HTTP", "", 8080));
        bench.show();
        assertEquals("Ports: P2OS 8101  HTTP 8080", bench.spoken("ports"));
    }

    @Test
    void eventsAreReadInWordsOfAllRobotsOrOfTheSelectedOne() {
        bench.events = List.of(
                new LoggedEvent(0, "anna", new RobotEvent.Added("5550200")),
                new LoggedEvent(1_230_000_000L, "bert", new RobotEvent.OrderVerified("**#**20**", "accepted")),
                new LoggedEvent(2_000_000_000L, "anna", new RobotEvent.StatusChanged(RobotStatus.COLLISION)));
        bench.show();
        bench.click("tab.events");
        EventsCard card = card();
        assertEquals(
                "0:00:00.00\tanna\tadded, number 5550200\n"
                        + "0:00:01.23\tbert\torder **#**20**: accepted\n"
                        + "0:00:02.00\tanna\tCollision\n",
                card.copied());
        ((JCheckBox) bench.component("events.only")).doClick(0);
        assertEquals("0:00:00.00\tanna\tadded, number 5550200\n0:00:02.00\tanna\tCollision\n", card.copied());
        ((JList<?>) bench.component("events")).setSelectedIndex(1);
        assertEquals("0:00:02.00\tanna\tCollision\n", card.copied());
        assertEquals("Collision", ((JTextArea) bench.component("events.whole")).getText());
    }

    /** A full log loses its first line with each new one; the index of the chosen line was kept, and so another was chosen. */
    @Test
    void theChosenEventStaysChosenWhileRowsGo() {
        LoggedEvent first = new LoggedEvent(0, "anna", new RobotEvent.Added("5550200"));
        LoggedEvent collision = new LoggedEvent(1, "anna", new RobotEvent.StatusChanged(RobotStatus.COLLISION));
        LoggedEvent ofBert = new LoggedEvent(2, "bert", new RobotEvent.Added("5550201"));
        bench.events = List.of(first, collision, ofBert);
        bench.show();
        bench.click("tab.events");
        JList<?> list = (JList<?>) bench.component("events");
        list.setSelectedIndex(2);
        bench.events = List.of(collision, ofBert, first);
        bench.show();
        assertEquals(List.of(ofBert), list.getSelectedValuesList());
        assertEquals("added, number 5550201", ((JTextArea) bench.component("events.whole")).getText());
        ((JCheckBox) bench.component("events.only")).doClick(0);
        assertTrue(list.isSelectionEmpty());
        assertFalse(bench.component("events.whole").isVisible());
    }

    @Test
    void eventsThatCameWhileTheLogWasHiddenAreThereWhenItIsShown() {
        bench.events = List.of(new LoggedEvent(0, "anna", new RobotEvent.Added("5550200")));
        bench.show();
        LoggedEvent collision = new LoggedEvent(9, "anna", new RobotEvent.StatusChanged(RobotStatus.COLLISION));
        bench.events = List.of(bench.events.get(0), collision);
        bench.show();
        bench.click("tab.events");
        assertEquals(2, ((JList<?>) bench.component("events")).getModel().getSize());
    }

    @Test
    void everyKindOfEventHasItsWords() {
        EventTexts words = new EventTexts(SimRobotTexts.in(Locale.ENGLISH));
        List<RobotEvent> events = List.of(
                new RobotEvent.Added("16"),
                new RobotEvent.Removed("16"),
                new RobotEvent.Registered("16"),
                new RobotEvent.Unregistered("16"),
                new RobotEvent.CallRinging("16"),
                new RobotEvent.CallReceived("16"),
                new RobotEvent.OrderVerified("16", "refused"),
                new RobotEvent.OrderAnswered(16, "refused"),
                new RobotEvent.ReplySent("16", "refused"),
                new RobotEvent.ReplyFailed("16", "refused"),
                new RobotEvent.BatteryChanged(true),
                new RobotEvent.UssdAnswered("16", "refused"),
                new RobotEvent.MessageReceived("16", "refused"),
                new RobotEvent.OrderSubmitted("ana", "** #**20 **"),
                new RobotEvent.TypeUnknown("16"),
                new RobotEvent.Said("Done"),
                new RobotEvent.WordHeard("two", "zero", 0.93, false),
                new RobotEvent.ClientMessage("16"),
                new RobotEvent.CallIdle(60),
                new RobotEvent.CallReleased(16),
                new RobotEvent.StatusChanged(RobotStatus.MOVING),
                new RobotEvent.BehaviourChanged(BehaviourKind.WANDER),
                new RobotEvent.Arrived(new Pose(1, 2, 90)),
                new RobotEvent.Placed(new Pose(1, 2, 90)),
                new RobotEvent.Printed("Dance", "1"),
                new RobotEvent.BehaviourFailed("Dance", 12, "ArithmeticException: / by zero"));
        for (ModemState state : ModemState.values()) {
            assertTrue(
                    words.of(new RobotEvent.ModemChanged(state, "TestNet").line("anna"))
                            .contains("modem"),
                    state.word());
        }
        for (RobotEvent event : events) {
            String text = words.of(new LoggedEvent(0, "anna", event).line());
            assertFalse(text.isBlank() || text.startsWith("log."), event + ": " + text);
        }
        // all but keys, tones and poses, which the log leaves out, and the modem's states
        assertEquals(RobotEvent.class.getPermittedSubclasses().length - 4, events.size());
    }

    private EventsCard card() {
        var component = bench.component("events");
        while (!(component instanceof EventsCard)) {
            component = component.getParent();
        }
        return (EventsCard) component;
    }
}

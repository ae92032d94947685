package simrobot.ui.inspector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JList;
import javax.swing.JTextArea;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEvent;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.ui.panel.WindowBench;

/** The tab of the processes: what can be started, what runs, what is wrong. */
class ProcessesCardTest {
    private WindowBench bench;

    @BeforeEach
    void open() throws Exception {
        bench = new WindowBench("office.map", Locale.ENGLISH, "anna", "bert");
    }

    private JList<?> list() {
        return (JList<?>) bench.component("processes");
    }

    @Test
    void theChosenProcessIsStartedInTheSelectedRobotAndMarked() {
        list().setSelectedIndex(1);
        ((AbstractButton) bench.component("processes.start")).doClick(0);
        assertTrue(bench.acts.contains("behaviour anna wall-follow"), bench.acts.toString());
        bench.show();
        assertEquals("#*2  follow walls (running)", list().getModel().getElementAt(1));
        assertEquals(1, list().getSelectedIndex());
        ((AbstractButton) bench.component("processes.stop")).doClick(0);
        assertTrue(bench.acts.contains("behaviour anna none"), bench.acts.toString());
    }

    @Test
    void theLast8LinesThatTheSelectedRobotHasPrintedAreShown() {
        bench.events = IntStream.rangeClosed(0, 9)
                .mapToObj(line -> new LoggedEvent(
                        line, line == 5 ? "bert" : "anna", new RobotEvent.Printed("Dance", "step " + line)))
                .toList();
        bench.show();
        assertEquals(
                "step 1\nstep 2\nstep 3\nstep 4\nstep 6\nstep 7\nstep 8\nstep 9",
                ((JTextArea) bench.component("processes.printed")).getText());
    }

    @Test
    void aProcessOfAStudentAppearsWithItsNumberAndItsFault() {
        bench.simulation.behaviours().put(new BehaviourKind("Dance", null));
        bench.simulation.behaviours().setFault(new BehaviourList.Fault("Dance", 12, "';' expected"));
        bench.show();
        assertEquals("#*3  Dance", list().getModel().getElementAt(2));
        assertEquals("Dance, line 12: ';' expected", ((JTextArea) bench.component("processes.faults")).getText());
        bench.simulation.behaviours().remove("Dance");
        bench.simulation.behaviours().clearFault("Dance");
        bench.show();
        assertEquals(3, list().getModel().getSize());
        assertEquals("", ((JTextArea) bench.component("processes.faults")).getText());
    }
}

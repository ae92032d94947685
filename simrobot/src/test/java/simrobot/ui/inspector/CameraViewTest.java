package simrobot.ui.inspector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.awt.image.BufferedImage;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.SimRobotTexts;
import simrobot.world.Position;
import simrobot.world.World;

class CameraViewTest {
    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final CameraView view = new CameraView(SimRobotTexts.in(Locale.ENGLISH));

    private void show() {
        SimulationSnapshot scene = simulation.snapshot();
        view.show(scene, scene.robots().get(0));
        view.drawNow();
    }

    /** The colour in the view's middle, and a little below, where a robot ahead would be. */
    private int seen() {
        view.setSize(320, 240);
        BufferedImage image = new BufferedImage(320, 240, BufferedImage.TYPE_INT_RGB);
        view.paint(image.createGraphics());
        return image.getRGB(160, 185);
    }

    @Test
    void itShowsWhatStandsBeforeTheRobot() {
        simulation.addRobot("ann", new Position(0, 0), 0);
        show();
        int floor = seen();
        simulation.addRobot("bob", new Position(1, 0), Math.PI);
        show();
        assertNotEquals(floor, seen());
        assertEquals("Camera of ann", view.getAccessibleContext().getAccessibleName());
    }

    @Test
    void aRobotThatIsOffHasNoPictureAndTheViewSaysSo() {
        simulation.addRobot("ann", new Position(0, 0), 0).setPower(false);
        show();
        assertEquals("The robot is off", view.getAccessibleContext().getAccessibleName());
    }
}

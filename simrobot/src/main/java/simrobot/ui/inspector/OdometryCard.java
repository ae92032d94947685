package simrobot.ui.inspector;

import java.awt.BorderLayout;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simrobot.drawing.NumberTexts;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.ValueRow;
import vericommand.Pose;

/** The pose by odometry, and its error against the true pose. */
final class OdometryCard extends JPanel {
    private final ValueRow x = new ValueRow("odometry.x", "x", "m");
    private final ValueRow y = new ValueRow("odometry.y", "y", "m");
    private final ValueRow heading;
    private final ValueRow error;
    private final ValueRow turned;

    OdometryCard(TextBundle texts) {
        super(new BorderLayout());
        setOpaque(false);
        heading = new ValueRow("odometry.heading", texts.of("pose.heading"), "\u00b0");
        error = new ValueRow("odometry.error", texts.of("odometry.error"), "m");
        turned = new ValueRow("odometry.turned", texts.of("odometry.turned"), "\u00b0");
        add(new Card(texts.of("odometry.title"), Arrange.column(0, x, y, heading, error, turned))
                .folding("fold.odometry"));
    }

    void show(RobotSnapshot robot) {
        Pose told = robot.condition().odometry();
        Pose estimated = robot.condition().estimated();
        x.show(NumberTexts.meters(told.xMeters()));
        y.show(NumberTexts.meters(told.yMeters()));
        heading.show(NumberTexts.degrees(Math.toRadians(told.headingDegrees())));
        error.show(NumberTexts.meters(
                Math.hypot(estimated.xMeters() - robot.xMeters(), estimated.yMeters() - robot.yMeters())));
        turned.show(NumberTexts.fixed(
                Math.IEEEremainder(estimated.headingDegrees() - Math.toDegrees(robot.headingRadians()), 360), 1));
    }
}

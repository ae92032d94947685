package simrobot.ui;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simrobot.simulation.RobotSnapshot;

/** The column beside the floor: which robots there are, and all about the selected one. */
final class Inspector extends JPanel {
    private final RobotList robots;
    private final StatusLamps statuses;
    private final Reading x;
    private final Reading y;
    private final Reading heading;
    private final Reading speed;
    private final Reading turn;
    private final SonarRose sonar;

    Inspector(Texts texts, Consumer<String> selection) {
        super(new BorderLayout());
        setOpaque(false);
        robots = new RobotList(texts, selection);
        statuses = new StatusLamps(texts);
        x = new Reading("pose.x", "x", "m");
        y = new Reading("pose.y", "y", "m");
        heading = new Reading("pose.heading", texts.of("pose.heading"), "\u00b0");
        speed = new Reading("pose.speed", texts.of("pose.speed"), "m/s");
        turn = new Reading("pose.turn", texts.of("pose.turn"), "\u00b0/s");
        sonar = new SonarRose(texts);
        Card list = new Card(texts.of("robots.title"), Arrange.column(10, robots.component(), statuses));
        Card pose = new Card(texts.of("pose.title"), Arrange.column(0, x, y, heading, speed, turn));
        Card rose = new Card(texts.of("sonar.title"), sonar);
        add(Arrange.column(Theme.GRID, list, pose, Arrange.growing(rose)), BorderLayout.CENTER);
    }

    void show(List<RobotList.Row> rows, Optional<RobotSnapshot> selected) {
        robots.show(rows, selected.map(RobotSnapshot::name).orElse(null));
        statuses.show(selected.map(RobotSnapshot::status).orElse(null));
        selected.ifPresent(this::show);
    }

    private void show(RobotSnapshot robot) {
        x.show(PoseTexts.meters(robot.xMeters()));
        y.show(PoseTexts.meters(robot.yMeters()));
        heading.show(PoseTexts.degrees(robot.headingRadians()));
        speed.show(PoseTexts.fixed(robot.speedMetersPerSecond(), 2));
        turn.show(PoseTexts.fixed(Math.toDegrees(robot.turnRadiansPerSecond()), 1));
        sonar.show(robot.sonarRangesMeters());
    }
}

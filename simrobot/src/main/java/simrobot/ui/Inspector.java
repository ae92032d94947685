package simrobot.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

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
    private final CameraView camera;

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
        camera = new CameraView(texts);
        Card list = new Card(texts.of("robots.title"), Arrange.column(10, robots.component(), statuses));
        Card pose = new Card(texts.of("pose.title"), Arrange.column(0, x, y, heading, speed, turn));
        Card rose = new Card(texts.of("sonar.title"), sonar);
        Card view = new Card(texts.of("camera.title"), camera);
        JScrollPane all =
                new RoomForItsBar(new Column(Arrange.column(Theme.GRID, list, pose, view, Arrange.growing(rose))));
        all.setBorder(null);
        all.setViewportBorder(null);
        all.setOpaque(false);
        all.getViewport().setOpaque(false);
        all.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        add(all, BorderLayout.CENTER);
    }

    /** As wide as its view and its scroll bar, so that nothing narrows when the bar appears. */
    private static final class RoomForItsBar extends JScrollPane {
        RoomForItsBar(Column column) {
            super(column);
        }

        @Override
        public Dimension getPreferredSize() {
            Dimension view = super.getPreferredSize();
            Dimension bar = getVerticalScrollBar().getPreferredSize();
            return getVerticalScrollBar().isVisible() ? new Dimension(view.width + bar.width, view.height) : view;
        }
    }

    /** As high as its view, or as its cards need at least: then it scrolls. */
    private static final class Column extends JPanel implements Scrollable {
        Column(JPanel content) {
            super(new BorderLayout());
            setOpaque(false);
            add(content, BorderLayout.CENTER);
        }

        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
            return Theme.px(20);
        }

        @Override
        public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
            return visible.height;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return getParent() != null && getParent().getHeight() >= getMinimumSize().height;
        }
    }

    void show(List<RobotList.Row> rows, SimulationSnapshot scene, Optional<RobotSnapshot> selected) {
        robots.show(rows, selected.map(RobotSnapshot::name).orElse(null));
        statuses.show(selected.map(RobotSnapshot::status).orElse(null));
        selected.ifPresent(this::show);
        selected.ifPresent(robot -> camera.show(scene, robot));
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

package simrobot.ui;

import java.awt.GridLayout;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simrobot.drawing.StatusLook;
import vericommand.RobotStatus;

/** The five statuses, each with a mark and a word; the current one is lit. */
public final class StatusLamps extends JPanel {
    private final Map<RobotStatus, Lamp> lamps = new EnumMap<>(RobotStatus.class);
    private final TextBundle texts;

    public StatusLamps(TextBundle texts) {
        super(new GridLayout(0, 2, 0, Theme.px(4)));
        this.texts = texts;
        setOpaque(false);
        setName("statuses");
        for (RobotStatus status : RobotStatus.values()) {
            Lamp lamp = new Lamp(texts.of("status.name")).saysWhenUnlit(texts.of("status.unlit"));
            lamp.setName("status." + status.name().toLowerCase(Locale.ROOT));
            lamp.show(StatusLook.mark(status), StatusLook.ink(status), word(texts, status));
            lamp.setLit(false);
            lamps.put(status, lamp);
            add(lamp);
        }
    }

    public static String word(TextBundle texts, RobotStatus status) {
        return texts.of("status." + status.name().toLowerCase(Locale.ROOT));
    }

    /** @param current null when no robot is selected */
    public void show(RobotStatus current) {
        lamps.forEach((status, lamp) -> lamp.setLit(status == current));
        getAccessibleContext()
                .setAccessibleName(texts.of("status.name") + (current == null ? "" : ": " + word(texts, current)));
    }
}

package blackbox;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;

/**
 * The three programs with their windows in one process, worked with mouse and keyboard as a person would: the phone dials
 * the robot with the mouse, keys an order, and the pose in SimRobot's window changes. {@link WindowsTest} starts it where
 * there is a display. It prints what it sees, and its exit status is 0 only if everything went as it should.
 */
final class WindowSession {
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final int LOOK_AGAIN_MILLIS = 40;
    private static final int KEY_MILLIS = 110;

    private final Robot hand;

    private WindowSession() throws AWTException {
        hand = new Robot();
    }

    /** @param args the centre's port, its data folder, and SimRobot's world */
    public static void main(String[] args) {
        int status = 1;
        try {
            launch(
                    "centre",
                    () -> simgsm.center.CenterMain.main(new String[] {
                        "--port", args[0], "--data", args[1], "--lang", "en", "--fresh", "--window", "300,500"
                    }));
            launch(
                    "robot",
                    () -> simrobot.SimRobotMain.main(new String[] {
                        "--number",
                        "5550200",
                        "--world",
                        args[2],
                        "--center",
                        "127.0.0.1:" + args[0],
                        "--lang",
                        "en",
                        "--no-sound",
                        "--fresh",
                        "--window",
                        "380,0"
                    }));
            launch(
                    "phone",
                    () -> simgsm.phone.PhoneMain.main(new String[] {
                        "--number",
                        "5550100",
                        "--center",
                        "127.0.0.1:" + args[0],
                        "--lang",
                        "en",
                        "--no-sound",
                        "--fresh",
                        "--window",
                        "0,0"
                    }));
            new WindowSession().play();
            status = 0;
        } catch (Exception | AssertionError e) {
            e.printStackTrace(System.out);
        }
        Runtime.getRuntime().halt(status);
    }

    private static void launch(String name, Runnable program) {
        Thread thread = new Thread(program, name);
        thread.setDaemon(true);
        thread.start();
    }

    private void play() throws Exception {
        Frame center = frame("SMSyCT");
        Frame robot = frame("SimRobot");
        Frame phone = frame("Sim Cellular");
        System.out.println("three windows: " + center.getTitle() + ", " + robot.getTitle() + ", " + phone.getTitle());
        // A window shows before it has its content.
        await(
                "both registered",
                () -> onEventThread(() -> search(phone, "lamp.link") != null && search(robot, "lamp.link") != null)
                        && name(phone, "lamp.link").contains("in service")
                        && name(robot, "lamp.link").contains("in service"));
        double before = pose(robot, "pose.x");

        System.out.println("the mouse dials 5550200");
        raise(phone);
        for (char digit : "5550200".toCharArray()) {
            click(phone, "key." + digit);
        }
        click(phone, "key.call");
        await("tone 1", () -> name(phone, "lcd").contains("connection accepted"));

        System.out.println("and keys ** #**20 **");
        for (char key : "**#**20**".toCharArray()) {
            click(phone, "key." + key);
        }
        await("tone 3", () -> name(phone, "lcd").contains("executed"));
        await("the robot 0.200 m further", () -> Math.abs(pose(robot, "pose.x") - before - 0.2) < 0.0015);
        System.out.println("the robot moved from " + before + " to " + pose(robot, "pose.x"));

        System.out.println("the keyboard turns it");
        for (char key : "**#*#90**".toCharArray()) {
            strike(key);
        }
        System.out.println("the display says " + name(phone, "lcd"));
        await("heading 270", () -> Math.abs(pose(robot, "pose.heading") - 270) < 0.2);
        hand.keyPress(KeyEvent.VK_ESCAPE);
        hand.keyRelease(KeyEvent.VK_ESCAPE);
        await("the call is over", () -> !name(phone, "lcd").contains("connected"));
        System.out.println("the display says " + name(phone, "lcd"));
        menu(phone);
        help(robot);
        System.out.println("done");
    }

    /** The phone's menu by the keyboard: redialling, a service of the network, another language. */
    private void menu(Frame phone) throws Exception {
        System.out.println("Enter shows the numbers dialled before");
        press(KeyEvent.VK_ESCAPE);
        press(KeyEvent.VK_ENTER);
        await("the dialled numbers", () -> name(phone, "lcd").equals("Dialled numbers: 5550200"));
        press(KeyEvent.VK_ENTER);
        await("the call's details", () -> name(phone, "lcd").contains("Duration"));
        press(KeyEvent.VK_ESCAPE);
        System.out.println("and the green key dials the last one again");
        press(KeyEvent.VK_ENTER);
        press(KeyEvent.VK_F6);
        await("tone 1 again", () -> name(phone, "lcd").contains("connection accepted"));
        press(KeyEvent.VK_ESCAPE);
        await("the call is over", () -> !name(phone, "lcd").contains("connected"));
        System.out.println("the menu asks for the own number");
        press(KeyEvent.VK_F3);
        strike('4');
        strike('1');
        await("the network's answer", () -> name(phone, "lcd").startsWith("5550100"));
        press(KeyEvent.VK_F4);
        System.out.println("and speaks Spanish");
        press(KeyEvent.VK_F3);
        for (char key : "512".toCharArray()) {
            strike(key);
        }
        await("Spanish", () -> name(phone, "lcd").startsWith("Ajustes"));
        await("a Spanish window", () -> name(phone, "key.end").equals("Colgar"));
    }

    /** The help stays on the screen when everything grows, and keeps a size given by hand when its colours change. */
    private void help(Frame robot) throws Exception {
        System.out.println("the help, twice as large");
        Rectangle screen = robot.getGraphicsConfiguration().getBounds();
        act(robot, "window.help");
        Window help = await(
                "the help",
                () -> onEventThread(() -> Stream.of(robot.getOwnedWindows())
                        .filter(each -> each.isShowing() && search(each, "help.tabs") != null)
                        .findFirst()
                        .orElse(null)));
        for (int i = 0; i < 8; i++) {
            act(robot, "window.zoom.in");
        }
        await("the help on the screen", () -> onEventThread(() -> screen.contains(help.getBounds())));
        Dimension chosen = new Dimension(700, 500);
        onEventThread(() -> {
            help.setSize(chosen);
            return true;
        });
        act(robot, "window.appearance");
        act(robot, "window.appearance");
        await("the help in its size", () -> onEventThread(() -> chosen.equals(help.getSize())));
    }

    private static void act(Frame frame, String action) throws Exception {
        JRootPane root = ((JFrame) frame).getRootPane();
        onEventThread(() -> {
            root.getActionMap().get(action).actionPerformed(null);
            return true;
        });
    }

    private void press(int code) {
        hand.keyPress(code);
        hand.delay(KEY_MILLIS);
        hand.keyRelease(code);
        hand.delay(KEY_MILLIS);
    }

    private Frame frame(String title) throws Exception {
        return await("a window called " + title, () -> {
            for (Frame frame : Frame.getFrames()) {
                if (frame.isShowing() && frame.getTitle().contains(title)) {
                    return frame;
                }
            }
            return null;
        });
    }

    private void raise(Frame frame) throws Exception {
        onEventThread(() -> {
            frame.toFront();
            return true;
        });
        hand.waitForIdle();
    }

    private void click(Frame frame, String name) throws Exception {
        Point place = onEventThread(() -> {
            Component component = find(frame, name);
            Point corner = component.getLocationOnScreen();
            return new Point(corner.x + component.getWidth() / 2, corner.y + component.getHeight() / 2);
        });
        hand.mouseMove(place.x, place.y);
        hand.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        hand.delay(KEY_MILLIS);
        hand.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        hand.delay(KEY_MILLIS);
    }

    private void strike(char key) {
        boolean shifted = key == '*' || key == '#';
        int code = key == '*' ? KeyEvent.VK_8 : key == '#' ? KeyEvent.VK_3 : KeyEvent.VK_0 + key - '0';
        if (shifted) {
            hand.keyPress(KeyEvent.VK_SHIFT);
        }
        hand.keyPress(code);
        hand.delay(KEY_MILLIS);
        hand.keyRelease(code);
        if (shifted) {
            hand.keyRelease(KeyEvent.VK_SHIFT);
        }
        hand.delay(KEY_MILLIS);
    }

    private static double pose(Frame robot, String name) throws Exception {
        return Double.parseDouble(name(robot, name).replaceFirst("^.*: *(-?[0-9.]+).*$", "$1"));
    }

    /** What a screen reader would say of the component. */
    private static String name(Frame frame, String componentName) throws Exception {
        return onEventThread(
                () -> find(frame, componentName).getAccessibleContext().getAccessibleName());
    }

    private static Component find(Container root, String name) {
        Component found = search(root, name);
        if (found == null) {
            throw new AssertionError("no component " + name + " in " + root);
        }
        return found;
    }

    private static Component search(Component component, String name) {
        if (name.equals(component.getName())) {
            return component;
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                Component found = search(child, name);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    private static <T> T onEventThread(Callable<T> look) throws Exception {
        FutureTask<T> task = new FutureTask<>(look);
        try {
            SwingUtilities.invokeAndWait(task);
        } catch (InvocationTargetException e) {
            throw new AssertionError(e.getCause());
        }
        return task.get();
    }

    /** Looks again and again, as a person does, until there is something that is neither null nor false. */
    private <T> T await(String what, Callable<T> look) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (System.nanoTime() < end) {
            T seen = look.call();
            if (seen != null && !Boolean.FALSE.equals(seen)) {
                return seen;
            }
            hand.delay(LOOK_AGAIN_MILLIS);
        }
        throw new AssertionError("waited in vain for " + what);
    }
}

package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import java.awt.Rectangle;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The demo's windows as a window manager places them and X11 tools see them. */
@Tag("peer")
class DemoWindowsTest {
    private static final long PATIENCE_SECONDS = 60;
    private static final List<String> TITLES = List.of("Sim Cellular 5550100", "SimRobot 5550200", "SMSyCT");

    @TempDir
    Path folder;

    private final List<Process> running = new ArrayList<>();
    private String display;

    @BeforeEach
    void peers() {
        Peer.XVFB.require();
        Peer.OPENBOX.require();
        Peer.XDOTOOL.require();
        Peer.XWININFO.require();
    }

    @AfterEach
    void end() throws InterruptedException {
        for (int i = running.size() - 1; i >= 0; i--) {
            running.get(i).destroy();
            running.get(i).waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
    }

    @ParameterizedTest(name = "{0} x {1}, zoom {2}")
    @CsvSource({"1280, 720, ", "1920, 1080, ", "1920, 1080, 150"})
    void noWindowCoversAnotherOrLeavesTheScreen(int width, int height, String zoom) throws Exception {
        screen(width, height);
        demo(zoom == null ? new String[0] : new String[] {"--zoom", zoom});
        Rectangle whole = new Rectangle(0, 0, width, height);
        // The window manager moves a window after it is visible, when it has a frame.
        long deadline = deadline();
        List<String> faults = faults(whole);
        while (!faults.isEmpty() && System.nanoTime() < deadline) {
            faults = faults(whole);
        }
        assertEquals(List.of(), faults);
        // The user dials first, whichever window has opened last.
        String focused = focused();
        while (!focused.equals(TITLES.get(0)) && System.nanoTime() < deadline) {
            focused = focused();
        }
        assertEquals(TITLES.get(0), focused);
    }

    private String focused() throws Exception {
        return look(Peer.XDOTOOL, "getwindowfocus", "getwindowname").strip();
    }

    private List<String> faults(Rectangle screen) {
        List<String> faults = new ArrayList<>();
        Map<String, Rectangle> windows = TITLES.stream().collect(Collectors.toMap(Function.identity(), this::boundsOf));
        for (String title : TITLES) {
            Rectangle window = windows.get(title);
            if (!screen.contains(window)) {
                faults.add(title + " leaves the screen: " + window);
            }
            for (String other : TITLES) {
                if (!title.equals(other) && window.intersects(windows.get(other))) {
                    faults.add(title + " " + window + " meets " + other + " " + windows.get(other));
                }
            }
        }
        return faults;
    }

    @Test
    void aPhoneThatWasClosedIsStartedAgainWithItsNumber() throws Exception {
        screen(1920, 1080);
        Process demo = demo();
        String phone = window(TITLES.get(0));
        ProcessHandle program = demo.toHandle()
                .descendants()
                .filter(child -> Arrays.stream(child.info().arguments().orElse(new String[0]))
                        .anyMatch(argument -> argument.endsWith("simgsm-phone.jar")))
                .findFirst()
                .orElseThrow();
        xdotool("windowactivate", "--sync", phone, "key", "--clearmodifiers", "alt+F4");
        program.onExit().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        xdotool("windowactivate", "--sync", window("SMSyCT"), "key", "--clearmodifiers", "alt+p");
        assertFalse(window(TITLES.get(0)).isEmpty());
    }

    @Test
    void aProgramThatCannotStartSaysSoInAWindow() throws Exception {
        screen(1280, 720);
        Process robot = start(
                onDisplay(new ProcessBuilder(Dist.command("simrobot", List.of("--world", "nope.map", "--lang", "en")))
                        .redirectErrorStream(true)));
        xdotool("windowactivate", "--sync", window("simrobot cannot start"), "key", "Escape");
        assertTrue(robot.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        String printed = new String(robot.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(printed.contains("nope.map: no such file"), printed);
        assertEquals(74, robot.exitValue());
    }

    @Test
    void f11InTheCentreFillsTheScreenAndItsConsoleAnswersBesideTheWindow() throws Exception {
        screen(1920, 1080);
        Process center = start(onDisplay(new ProcessBuilder(Dist.command(
                "simgsm-center", List.of("--console", "--fresh", "--port=0", "--lang=en", "--data=" + folder)))));
        BufferedReader events = center.inputReader(StandardCharsets.UTF_8);
        assertTrue(events.readLine().startsWith("ready port="));
        String window = window("SMSyCT");
        Rectangle before = boundsOf("SMSyCT");
        xdotool("windowactivate", "--sync", window, "key", "F11");
        long deadline = deadline();
        while (boundsOf("SMSyCT").width < 1900 || boundsOf("SMSyCT").height < 1000) {
            assertTrue(System.nanoTime() < deadline, boundsOf("SMSyCT").toString());
        }
        xdotool("windowactivate", "--sync", window, "key", "F11");
        while (!boundsOf("SMSyCT").getSize().equals(before.getSize())) {
            assertTrue(System.nanoTime() < deadline, boundsOf("SMSyCT").toString());
        }
        try (Writer commands = center.outputWriter(StandardCharsets.UTF_8)) {
            commands.write("subscribers\nquit\n");
        }
        assertEquals("end of=subscribers count=0", events.readLine());
        assertTrue(center.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertEquals(0, center.exitValue());
    }

    @Test
    void escapeLeavesTheLargeLadderOfALowWindow() throws Exception {
        screen(1366, 768);
        start(onDisplay(new ProcessBuilder(Dist.command(
                "simgsm-center",
                List.of("--fresh", "--port=0", "--lang=en", "--data=" + folder, "--window=340,430,1000,300")))));
        String window = window("SMSyCT");
        Rectangle before = boundsOf("SMSyCT");
        xdotool("windowactivate", "--sync", window, "key", "F11");
        long deadline = deadline();
        while (boundsOf("SMSyCT").width < 1300) {
            assertTrue(System.nanoTime() < deadline, boundsOf("SMSyCT").toString());
        }
        while (!boundsOf("SMSyCT").getSize().equals(before.getSize())) {
            xdotool("windowactivate", "--sync", window, "key", "Escape");
            assertTrue(System.nanoTime() < deadline, boundsOf("SMSyCT").toString());
        }
    }

    @Test
    void aClassSaysThatTheScreenHasNoRoomForItsZoom() throws Exception {
        screen(1920, 1080);
        Process demo = start(onDisplay(new ProcessBuilder(Dist.command(
                "simgsm-center", List.of("--demo", "--class=4", "--fresh", "--port=0", "--lang=en", "--zoom=150")))));
        assertTrue(demo.errorReader().readLine().contains("zoom 150 leaves no room for three windows on this screen"));
    }

    private void screen(int width, int height) throws Exception {
        // Xvfb complains of displays that are taken; only the number of its own belongs to standard output.
        Process server = start(Peer.XVFB
                .process(
                        "-displayfd", "1", "-screen", "0", width + "x" + height + "x24", "-noreset", "-nolisten", "tcp")
                .redirectErrorStream(false)
                .redirectError(ProcessBuilder.Redirect.DISCARD));
        BufferedReader output =
                new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
        display = ":" + output.readLine().strip();
        start(onDisplay(Peer.OPENBOX.process().redirectOutput(ProcessBuilder.Redirect.DISCARD)));
        // Java asks once, at its start, whether there is a window manager.
        look(Peer.XDOTOOL, "get_num_desktops");
    }

    private Process demo(String... more) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-jar",
                Dist.jar("simgsm-center").toString(),
                "--demo",
                "--fresh",
                "--port",
                "0",
                "--lang",
                "en"));
        command.addAll(List.of(more));
        Process demo = start(onDisplay(new ProcessBuilder(command)
                .directory(Dist.root().toFile())
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)));
        for (String title : TITLES) {
            window(title);
        }
        return demo;
    }

    private Process start(ProcessBuilder builder) throws Exception {
        Process process = builder.start();
        running.add(process);
        return process;
    }

    private ProcessBuilder onDisplay(ProcessBuilder builder) {
        builder.environment().put("DISPLAY", display);
        return builder;
    }

    /** The number of the visible window with this title, once it is there. */
    private String window(String title) throws Exception {
        return look(Peer.XDOTOOL, "search", "--sync", "--onlyvisible", "--name", "^" + title + "$")
                .lines()
                .findFirst()
                .orElse("");
    }

    /** The window without its frame. */
    private Rectangle boundsOf(String title) {
        try {
            Map<String, Integer> values = look(Peer.XWININFO, "-id", window(title))
                    .lines()
                    .map(line -> line.strip().split(":\\s+"))
                    .filter(pair -> pair.length == 2 && pair[1].matches("-?[0-9]+"))
                    .collect(Collectors.toMap(pair -> pair[0], pair -> Integer.parseInt(pair[1])));
            return new Rectangle(
                    values.get("Absolute upper-left X"),
                    values.get("Absolute upper-left Y"),
                    values.get("Width"),
                    values.get("Height"));
        } catch (Exception e) {
            throw new AssertionError(title, e);
        }
    }

    private void xdotool(String... words) throws Exception {
        Peer.run(onDisplay(Peer.XDOTOOL.process(words))).expectSuccess();
    }

    /** Looks again where a tool fails: it ends with an error when a window has gone while it looks at all of them. */
    private String look(Peer peer, String... words) throws Exception {
        long deadline = deadline();
        Peer.Output seen = Peer.run(onDisplay(peer.process(words)));
        while (seen.status() != 0 && System.nanoTime() < deadline) {
            seen = Peer.run(onDisplay(peer.process(words)));
        }
        return seen.expectSuccess();
    }

    private static long deadline() {
        return System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    }
}

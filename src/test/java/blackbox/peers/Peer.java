package blackbox.peers;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import blackbox.Dist;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A program from elsewhere, found on PATH; Python and Node libraries also under {@code target/peers}. */
enum Peer {
    TSHARK("tshark"),
    TOAST("toast"),
    UNTOAST("untoast"),
    SOX("sox"),
    MULTIMON_NG("multimon-ng"),
    LAME("lame"),
    OPUSENC("opusenc"),
    OPUSDEC("opusdec"),
    C_COMPILER("cc"),
    PYTHON("python3"),
    NODE("node"),
    CURL("curl"),
    BARESIP("baresip"),
    LINPHONEC("linphonec"),
    SIPP("sipp"),
    SWAKS("swaks"),
    BEARERBOX("bearerbox"),
    SMSBOX("smsbox"),
    SOCAT("socat"),
    GAMMU("gammu"),
    SMSD("smsd"),
    MODEM_MANAGER("ModemManager"),
    MMCLI("mmcli"),
    WVDIAL("wvdial"),
    OFONO("ofonod"),
    BASH("bash"),
    OSMO_STP("osmo-stp"),
    OSMO_HLR("osmo-hlr"),
    OSMO_MGW("osmo-mgw"),
    OSMO_MSC("osmo-msc"),
    OSMO_BSC("osmo-bsc"),
    OSMO_BTS("osmo-bts-omldummy"),
    CHROMIUM("chromium"),
    ZBARIMG("zbarimg"),
    XVFB("Xvfb"),
    OPENBOX("openbox"),
    XDOTOOL("xdotool"),
    XWININFO("xwininfo"),
    PULSEAUDIO("pulseaudio"),
    PACTL("pactl"),
    PAREC("parec"),
    PAPLAY("paplay"),
    FLITE("flite"),
    ESPEAK_NG("espeak-ng"),
    TIFFINFO("tiffinfo"),
    TIFFCMP("tiffcmp");

    /** Where {@code src/test/peers/install.sh} puts libraries. */
    static final Path LIBRARIES = Dist.root().resolve("target").resolve("peers");

    /** A script waits for up to 60 s in each of several places, so all of it may take longer than one wait; a guard only. */
    private static final int PATIENCE_MINUTES = 5;

    private final String program;

    Peer(String program) {
        this.program = program;
    }

    /** What a peer printed on both outputs, and its exit status. */
    record Output(int status, String text) {
        /** The text, once the peer has ended with 0. */
        String expectSuccess() {
            if (status != 0) {
                throw new AssertionError("exit status " + status + ": " + text);
            }
            return text;
        }
    }

    /** Skips the calling test, naming the peer, where it is not on PATH. */
    void require() {
        require(path() != null, program);
    }

    /** Skips the calling test where a peer is not there, and prints the peer's name. */
    static void require(boolean isThere, String name) {
        if (!isThere) {
            System.out.println("  peer missing, test skipped: " + name);
        }
        assumeTrue(isThere, name + " is not installed");
    }

    /** Where the peer is; null if it is not on PATH. */
    Path path() {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .map(folder -> Path.of(folder, program))
                .filter(Files::isExecutable)
                .findFirst()
                .orElse(null);
    }

    /** A process of this peer that is not started yet; error output joins standard output. */
    ProcessBuilder process(String... arguments) {
        require();
        List<String> command = new ArrayList<>(List.of(path().toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("PYTHONPATH", LIBRARIES.resolve("python").toString());
        builder.environment().put("NODE_PATH", LIBRARIES.resolve("node_modules").toString());
        return builder;
    }

    /** Runs the peer to its end. */
    Output run(String... arguments) throws IOException, InterruptedException {
        return run(process(arguments));
    }

    static Output run(ProcessBuilder builder) throws IOException, InterruptedException {
        Path printed = Files.createTempFile("peer", ".out");
        try {
            Process process = builder.redirectOutput(printed.toFile()).start();
            process.getOutputStream().close();
            if (!process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES)) {
                process.descendants().forEach(ProcessHandle::destroy);
                process.destroyForcibly();
                throw new AssertionError(builder.command() + " does not end: " + Files.readString(printed));
            }
            return new Output(process.exitValue(), Files.readString(printed));
        } finally {
            Files.delete(printed);
        }
    }

    /** A script or source file of {@code src/test/peers}. */
    static String source(String name) {
        return Dist.root().resolve("src/test/peers").resolve(name).toString();
    }
}

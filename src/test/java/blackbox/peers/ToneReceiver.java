package blackbox.peers;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Four DTMF receivers that read the same samples: raw files of 8 kHz, 16 bit, little-endian, mono. */
enum ToneReceiver {
    OURS {
        @Override
        List<String> keys(List<Path> files, Path spandsp) throws Exception {
            List<String> arguments = new ArrayList<>(List.of("decode"));
            for (Path file : files) {
                arguments.add(Audio.wav(Path.of(file + ".wav"), Files.readAllBytes(file))
                        .toString());
            }
            return Audio.tool(arguments.toArray(String[]::new))
                    .lines()
                    .map(line -> line.split("\t", -1)[1])
                    .toList();
        }
    },
    /** As it comes. */
    SPANDSP {
        @Override
        List<String> keys(List<Path> files, Path spandsp) throws Exception {
            return run(spandsp, "rx", files);
        }
    },
    /** With dial-tone notches and a twist of 10 and 6 dB. */
    SPANDSP_WIDE {
        @Override
        List<String> keys(List<Path> files, Path spandsp) throws Exception {
            return run(spandsp, "rx-wide", files);
        }
    },
    MULTIMON_NG {
        @Override
        List<String> keys(List<Path> files, Path spandsp) throws Exception {
            List<String> all = new ArrayList<>();
            for (Path file : files) {
                String resampled = file + ".22050";
                Peer.SOX
                        .run((Sound.RAW + " " + file + " -t raw -e signed -b 16 -r 22050 " + resampled).split(" "))
                        .expectSuccess();
                String heard = Peer.MULTIMON_NG
                        .run("-q", "-a", "DTMF", "-t", "raw", resampled)
                        .text();
                all.add(heard.lines()
                        .filter(line -> line.startsWith("DTMF: "))
                        .map(line -> line.substring("DTMF: ".length()).strip())
                        .collect(Collectors.joining()));
                Files.delete(Path.of(resampled));
            }
            return all;
        }
    };

    /**
     * The keys of each file.
     *
     * @param spandsp the compiled program around SpanDSP
     */
    abstract List<String> keys(List<Path> files, Path spandsp) throws Exception;

    private static List<String> run(Path program, String kind, List<Path> files) throws Exception {
        List<String> command = new ArrayList<>(List.of(program.toString(), kind));
        files.forEach(file -> command.add(file.toString()));
        return Peer.run(new ProcessBuilder(command)).expectSuccess().lines().toList();
    }

    /** The program around SpanDSP's sender, receiver and G.726, compiled; without the library the test is skipped. */
    static Path spandsp(Path folder) throws Exception {
        Path program = folder.resolve("spandsp_dtmf");
        Peer.Output compiled =
                Peer.C_COMPILER.run("-o", program.toString(), Peer.source("spandsp_dtmf.c"), "-lspandsp", "-lm");
        Peer.require(compiled.status() == 0, "SpanDSP (libspandsp-dev): " + compiled.text());
        return program;
    }
}

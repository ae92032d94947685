package simrobot.source;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.file.Utf8Text;
import simrobot.process.BehaviourList;

/**
 * {@code numbers.txt} of a folder of processes: an order's number for each name, {@code 3 Circle} a line, which stays when the
 * process is gone. Blank lines and lines that begin with {@code #} are skipped. Several SimRobots may share the file: new
 * lines are appended under a lock.
 */
final class NumbersFile {
    static final String NAME = "numbers.txt";
    private static final Pattern LINE = Pattern.compile("\\s*([1-9][0-9]?)\\s+(\\S+)\\s*");

    private final Path file;
    private String text = "";
    private Map<String, Integer> numbers = new HashMap<>();

    NumbersFile(Path folder) {
        file = folder.resolve(NAME);
    }

    Path file() {
        return file;
    }

    /** By name, also those of processes that are not there now. */
    Map<String, Integer> numbers() {
        return numbers;
    }

    /**
     * Reads the file if it has changed, and gives a number to each of these names that has none. If the file does not allow
     * that, the numbers hold for this object only.
     *
     * @return true if a number has changed
     * @throws SourceException with the line that is no number and name, or has one a second time
     * @throws IOException if the file cannot be read or written
     */
    boolean update(Collection<String> names) throws SourceException, IOException {
        String now = Files.exists(file) ? Utf8Text.read(file) : "";
        boolean isChanged = !now.equals(text);
        text = now;
        if (isChanged) {
            numbers = parsed(now);
        }
        List<String> missing =
                names.stream().filter(name -> !numbers.containsKey(name)).toList();
        if (missing.isEmpty()) {
            return isChanged;
        }
        try {
            append(missing);
        } finally {
            give(missing);
        }
        return true;
    }

    /** @return the new lines */
    private String give(List<String> names) {
        StringBuilder lines = new StringBuilder();
        for (String name : names) {
            if (!numbers.containsKey(name)) {
                BehaviourList.freeNumber(numbers.values()).ifPresent(number -> {
                    numbers.put(name, number);
                    lines.append(number).append(' ').append(name).append('\n');
                });
            }
        }
        return lines.toString();
    }

    private void append(List<String> names) throws SourceException, IOException {
        // a lock is the machine's: two threads of one program would not wait for each other
        synchronized (NumbersFile.class) {
            try (FileChannel channel = FileChannel.open(
                    file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
                // held until the channel is closed
                channel.lock();
                String now = new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8)
                        .replaceFirst("^\\uFEFF", "");
                numbers = parsed(now);
                text = now + (now.isEmpty() || now.endsWith("\n") ? "" : "\n") + give(names);
                ByteBuffer added = StandardCharsets.UTF_8.encode(text.substring(now.length()));
                while (added.hasRemaining()) {
                    channel.write(added);
                }
            }
        }
    }

    private static Map<String, Integer> parsed(String text) throws SourceException {
        Map<String, Integer> numbers = new HashMap<>();
        int count = 0;
        for (String line : text.split("\n", -1)) {
            count++;
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            Matcher matcher = LINE.matcher(line);
            int number = matcher.matches() ? Integer.parseInt(matcher.group(1)) : 0;
            if (number < BehaviourList.FIRST_OWN_NUMBER) {
                throw new SourceException(
                        count, "expected a number from 3 to 99 and a name, such as 3 Circle, found " + line.strip());
            }
            if (numbers.containsValue(number) || numbers.put(matcher.group(2), number) != null) {
                throw new SourceException(
                        count, "expected each number and each name once, found again: " + line.strip());
            }
        }
        return numbers;
    }
}

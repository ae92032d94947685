package simgsm.sms;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The broadcast channels (message identifiers) shown by a phone; the CBMI list of TS 31.102. Written as {@code
 * 50,919,4370-4399}, {@code all} or {@code none}.
 */
public final class ChannelList {
    public static final ChannelList ALL = new ChannelList(List.of(new Range(0, 0xffff)));
    public static final ChannelList NONE = new ChannelList(List.of());

    /** Most channels and ranges: the size of a SIM's EF CBMI. */
    static final int MAX_RANGES = 255;

    private static final int MAX_CHANNEL = 0xffff;
    private static final String EXPECTED =
            "expected all, none, or channels and ranges of 0 to 65535 as 50,919,4370-4399";

    private record Range(int first, int last) {
        @Override
        public String toString() {
            return first == last ? Integer.toString(first) : first + "-" + last;
        }
    }

    private final List<Range> ranges;

    private ChannelList(List<Range> ranges) {
        this.ranges = List.copyOf(ranges);
    }

    /** @throws IllegalArgumentException naming the expected form and the text found */
    public static ChannelList parse(String text) {
        if (text.equals("all")) {
            return ALL;
        }
        if (text.equals("none")) {
            return NONE;
        }
        List<Range> ranges = new ArrayList<>();
        for (String item : text.split(",", -1)) {
            ranges.add(range(item.strip()));
        }
        if (ranges.size() > MAX_RANGES) {
            throw new IllegalArgumentException(ranges.size() + " channels and ranges, at most " + MAX_RANGES);
        }
        return new ChannelList(ranges);
    }

    private static Range range(String item) {
        if (!item.matches("[0-9]{1,5}(-[0-9]{1,5})?")) {
            throw new IllegalArgumentException(EXPECTED + ", found " + (item.isEmpty() ? "nothing" : item));
        }
        String[] ends = item.split("-");
        int first = Integer.parseInt(ends[0]);
        int last = Integer.parseInt(ends[ends.length - 1]);
        if (first > last || last > MAX_CHANNEL) {
            throw new IllegalArgumentException(EXPECTED + ", found " + item);
        }
        return new Range(first, last);
    }

    /** True if the channel is in the list. */
    public boolean contains(int channel) {
        return ranges.stream().anyMatch(range -> channel >= range.first && channel <= range.last);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ChannelList that && ranges.equals(that.ranges);
    }

    @Override
    public int hashCode() {
        return ranges.hashCode();
    }

    /** In the form read by {@link #parse}. */
    @Override
    public String toString() {
        if (equals(ALL)) {
            return "all";
        }
        return ranges.isEmpty() ? "none" : ranges.stream().map(Range::toString).collect(Collectors.joining(","));
    }
}

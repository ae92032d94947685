package simrobot.world;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;

/**
 * Reads Saphira's {@code .wld}: {@code ;} comments, millimetres and degrees. Four integers are a wall, {@code push x y
 * phi} and {@code pop} nest frames, {@code position x y phi} is a robot's start.
 */
public final class SaphiraReader {
    /** Limit of nested frames. */
    static final int MAX_DEPTH = 1000;

    /** A local frame: an offset, then a rotation, within the enclosing frame. */
    private record Frame(double x, double y, double radians) {
        Frame inner(double dx, double dy, double turn) {
            Position origin = place(dx, dy);
            return new Frame(origin.xMeters(), origin.yMeters(), radians + turn);
        }

        Position place(double px, double py) {
            double cos = Math.cos(radians);
            double sin = Math.sin(radians);
            return new Position(x + px * cos - py * sin, y + px * sin + py * cos);
        }
    }

    private final WorldBuilder world;
    private final Deque<Frame> frames = new ArrayDeque<>();

    private SaphiraReader(String source) {
        world = new WorldBuilder(source);
        frames.push(new Frame(0, 0, 0));
    }

    /**
     * Reads a world from a text.
     *
     * @param source named in errors and as the world's name
     */
    public static World read(String source, String text) throws WorldFormatException {
        SaphiraReader reader = new SaphiraReader(source);
        List<String> lines = text.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i);
            int comment = line.indexOf(';');
            reader.accept(new LineTokens(source, i + 1, comment < 0 ? line : line.substring(0, comment)));
        }
        if (reader.frames.size() > 1) {
            throw new WorldFormatException(source, lines.size(), "the end of the file", "pop");
        }
        return reader.world.build();
    }

    private void accept(LineTokens tokens) throws WorldFormatException {
        if (tokens.hasMore()) {
            switch (tokens.peek().toLowerCase(Locale.ROOT)) {
                case "width", "height" -> extent(tokens);
                case "push" -> push(tokens);
                case "pop" -> pop(tokens);
                case "position" -> position(tokens);
                default -> wall(tokens);
            }
            tokens.end();
        }
    }

    /** Skips the size of Saphira's view of the world. */
    private static void extent(LineTokens tokens) throws WorldFormatException {
        String which = "the " + tokens.word("width or height");
        if (tokens.meters(which) < 0) {
            throw tokens.fault(which + " below 0", which + " in mm, 0 or more");
        }
    }

    private void push(LineTokens tokens) throws WorldFormatException {
        tokens.word("push");
        if (frames.size() > MAX_DEPTH) {
            throw tokens.fault("push number " + frames.size() + " inside another", "at most " + MAX_DEPTH);
        }
        frames.push(frames.element().inner(tokens.meters("x"), tokens.meters("y"), tokens.radians("phi")));
    }

    private void pop(LineTokens tokens) throws WorldFormatException {
        tokens.word("pop");
        if (frames.size() == 1) {
            throw tokens.fault("pop without push", "a wall or a keyword");
        }
        frames.pop();
    }

    private void position(LineTokens tokens) throws WorldFormatException {
        tokens.word("position");
        Frame frame = frames.element();
        Position place = frame.place(tokens.meters("x"), tokens.meters("y"));
        world.add(new Home("", place, frame.radians() + tokens.radians("phi")));
    }

    private void wall(LineTokens tokens) throws WorldFormatException {
        if (!tokens.peek().matches("[-+.0-9].*")) {
            throw tokens.fault(
                    '"' + tokens.peek() + '"', "width, height, push, pop, position or a wall's four numbers in mm");
        }
        Frame frame = frames.element();
        Position from = frame.place(tokens.meters("x1"), tokens.meters("y1"));
        Position to = frame.place(tokens.meters("x2"), tokens.meters("y2"));
        world.add(Segment.between(from, to));
    }
}

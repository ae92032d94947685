package simgsm.draw;

/**
 * A colour by its task. Pairs of text and background have a contrast of at least 4.5 to 1, in high contrast of 7 to
 * 1. Values: light, dark, high contrast.
 */
public enum Ink {
    /** Background of windows. */
    SURFACE(0xF6F7F9, 0x1E2126, 0xFFFFFF),
    /** Background of content on the surface. */
    CARD(0xFFFFFF, 0x272B31, 0xFFFFFF),
    /** Borders and rules. */
    LINE(0xD5D9E0, 0x3B4149, 0x8C8C8C),
    /** Borders of controls; 3 to 1 against the card. */
    CONTROL_LINE(0x848D9A, 0x79828D, 0x404040),
    TEXT(0x1B1F24, 0xE8EAED, 0x000000),
    QUIET(0x5B6470, 0xA6AEB8, 0x333333),
    DISABLED(0x99A1AC, 0x6C747E, 0x6B6B6B),
    ACCENT(0x1F5FBF, 0x7FB0FF, 0x0B3D91),
    /** Text on the accent. */
    ON_ACCENT(0xFFFFFF, 0x10141A, 0xFFFFFF),
    /** A thin wash of the accent: selections, the lit part of a track. */
    ACCENT_WASH(0xDFE9F8, 0x2C3B53, 0xD6E4FF),
    GOOD(0x1E7F4F, 0x5CC890, 0x0B5A2B),
    GOOD_WASH(0xE2F3EA, 0x233A2F, 0xDDF3E4),
    WARNING(0x9A6200, 0xF0B64A, 0x6B3A00),
    WARNING_WASH(0xFBF1DE, 0x3C3321, 0xFFF0D6),
    DANGER(0xB3261E, 0xFF8A80, 0x8E0B0B),
    DANGER_WASH(0xFBE6E4, 0x452B2B, 0xFFE3E0),
    /** Text on a filled good or danger key. */
    ON_SIGNAL(0xFFFFFF, 0x10141A, 0xFFFFFF),
    HOVER(0xEDF0F4, 0x30353C, 0xE6E6E6),
    PRESSED(0xDDE2E9, 0x3A4048, 0xCFCFCF),

    /** The handset's body, its keys' faces and lower edges. */
    BODY(0xDCE1E8, 0x2D3239, 0xE6E6E6),
    BODY_LINE(0xB4BCC7, 0x4A515B, 0x404040),
    KEY_FACE(0xFDFDFE, 0x3A4048, 0xFFFFFF),
    CALL_FACE(0x1E7F4F, 0x278052, 0x0B5A2B),
    END_FACE(0xB3261E, 0xC03A30, 0x8E0B0B),
    /** Signs on body and faces. */
    ON_FACE(0xFFFFFF, 0xFFFFFF, 0xFFFFFF),
    KEY_LINE(0xAAB3BF, 0x565E69, 0x404040),
    KEY_HOVER(0xF0F3F7, 0x434A53, 0xEDEDED),
    /** The display of the phone: the same in light and dark, like a real one. */
    LCD_PAPER(0xB9C9A3, 0xB9C9A3, 0xD4E3BD),
    LCD_INK(0x20301A, 0x20301A, 0x000000),
    LCD_QUIET(0x273420, 0x273420, 0x1F2E18),
    /** Segments that are off, faintly visible. */
    LCD_GHOST(0xA6B78F, 0xA6B78F, 0xC2D2AA),
    LCD_RIM(0x5E6B50, 0x10130E, 0x000000),

    /** The world view: floor, grid, walls, robot. */
    FLOOR(0xFCFCFA, 0x22262B, 0xFFFFFF),
    GRID_LINE(0xE9ECEF, 0x2C3137, 0xD0D0D0),
    GRID_MAJOR(0xD5D9E0, 0x3B4149, 0x9A9A9A),
    WALL(0x2B3037, 0xCDD3DA, 0x000000),
    ROBOT(0xC2402F, 0xE2705C, 0xA31515),
    ROBOT_LINE(0x5C160E, 0xFFD9D2, 0x000000),
    WHEEL(0x23272D, 0x14171B, 0x000000),
    TRAIL(0x1F5FBF, 0x7FB0FF, 0x0B3D91),
    RAY(0x9A6200, 0xF0B64A, 0x6B3A00),

    /**
     * Cells of a town, in the order of its towers; the eighth has the first colour. Drawn over FLOOR with an opacity
     * by signal strength.
     */
    CELL_1(0x3B7DD8, 0x5C9BEA),
    CELL_2(0xD9822B, 0xE59A4C),
    CELL_3(0x2E9E6B, 0x4CBF8A),
    CELL_4(0xB0559E, 0xC979B8),
    CELL_5(0xA8962A, 0xC4B24A),
    CELL_6(0x2F93A6, 0x58BFD0),
    CELL_7(0xC7524B, 0xE07A73);

    private final int light;
    private final int dark;
    private final int contrast;

    /** The light colour is strong enough for high contrast, too. */
    Ink(int light, int dark) {
        this(light, dark, light);
    }

    Ink(int light, int dark, int contrast) {
        this.light = light;
        this.dark = dark;
        this.contrast = contrast;
    }

    /** The colour as 0xRRGGBB. */
    public int rgb(Appearance appearance) {
        return switch (appearance) {
            case LIGHT -> light;
            case DARK -> dark;
            case CONTRAST -> contrast;
        };
    }

    /** The colour as CSS and SVG write it: {@code #rrggbb}. */
    public String hex(Appearance appearance) {
        return "#%06x".formatted(rgb(appearance));
    }
}

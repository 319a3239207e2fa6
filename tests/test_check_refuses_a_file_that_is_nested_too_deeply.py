from simpter_hybrid.cli import main


def test_check_refuses_a_file_that_is_nested_too_deeply(tmp_path, capsys):
    file = tmp_path / "deep.toml"
    file.write_text("x = " + "[" * 2000 + "]" * 2000)
    assert main(["check", str(file)]) != 0
    assert "nested too deeply" in capsys.readouterr().err
